// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

/// Which surface each lane has met; most packs see but one, and need not gather.
template <class V>
class Places {
 public:
  Places(IndexOf<V> place, MaskOf<V> lanes) {
    std::array<WholeOf<V>, Lanes<V>::count> places;
    store(place, places.data());
    common_ = places[static_cast<std::size_t>(std::countr_zero(bits(lanes)))];
    same_ = none(lanes & !(place == IndexOf<V>(common_)));
    each_ = select(lanes, place, IndexOf<V>(common_));
  }

  bool same() const { return same_; }
  std::size_t common() const { return static_cast<std::size_t>(common_); }
  IndexOf<V> each() const { return each_; }

 private:
  IndexOf<V> each_;
  WholeOf<V> common_;
  bool same_;
};

/// What the surfaces are like that the lanes have met.
template <class V>
struct Look {
  Vec3<V> color;
  V alpha, strength, mirror;
  MaskOf<V> glass;
  IndexOf<V> finish_row;
};

/// That of the surfaces at `places`.
template <class V>
Look<V> look_at(const Prepared<NumberOf<V>>& scene, const Places<V>& places) {
  using T = NumberOf<V>;
  using Index = IndexOf<V>;
  using Whole = WholeOf<V>;
  const T* const surfaces = scene.surfaces.numbers.data();
  const T* const finishes = scene.finishes.numbers.data();
  if (places.same()) {
    const T* const surface = surfaces + places.common() * surface_columns;
    const Whole row = static_cast<Whole>(surface[finish]) * finish_columns;
    const T* const look = finishes + row;
    return {{V(surface[red]), V(surface[green]), V(surface[blue])},
            V(look[alpha]),
            V(look[strength]),
            V(look[mirror]),
            V(look[is_glass]) > V(0),
            Index(row)};
  }
  const Index surface = shifted_left<std::countr_zero(unsigned{surface_columns})>(places.each());
  const Index row = shifted_left<std::countr_zero(unsigned{finish_columns})>(whole(gather(surfaces + finish, surface)));
  return {{gather(surfaces + red, surface), gather(surfaces + green, surface), gather(surfaces + blue, surface)},
          gather(finishes + alpha, row),
          gather(finishes + strength, row),
          gather(finishes + mirror, row),
          gather(finishes + is_glass, row) > V(0),
          row};
}

}  // namespace raylab::fast::RAYLAB_TARGET
