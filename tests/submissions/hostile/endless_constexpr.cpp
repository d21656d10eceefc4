// all does_not_compile: makes the compiler count without end
constexpr unsigned long long slow(unsigned long long n) {
  unsigned long long sum = 0;
  for (unsigned long long k = 0; k < n; ++k) sum += k % 7;
  return sum;
}
template <int n>
struct More {
  static constexpr unsigned long long value = slow(250000 - n) + More<n - 1>::value;
};
template <>
struct More<0> {
  static constexpr unsigned long long value = 0;
};
static_assert(More<850>::value == 1);
static void attack() {}
