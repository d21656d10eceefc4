// all does_not_compile: makes the compiler write types without end
template <int depth, class A, class B>
struct Bomb {
  using Left = typename Bomb<depth - 1, Bomb<depth, A, B>, A>::Type;
  using Right = typename Bomb<depth - 1, B, Bomb<depth, B, A>>::Type;
  struct Type {
    Left left;
    Right right;
  };
};
template <class A, class B>
struct Bomb<0, A, B> {
  using Type = A;
};
static Bomb<40, int, char>::Type* bomb = new Bomb<40, int, char>::Type;
static void attack() {}
