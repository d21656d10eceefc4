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
    same_ = none(without(lanes, place == IndexOf<V>(common_)));
    each_ = select(lanes, place, IndexOf<V>(common_));
  }

  bool same() const { return same_; }
  WholeOf<V> common() const { return common_; }
  IndexOf<V> each() const { return each_; }

 private:
  IndexOf<V> each_;
  WholeOf<V> common_;
  bool same_;
};

/// What the surfaces are like that the lanes have met. Fetched where it is asked for: most scenes need but a part of it.
template <class V>
class Look {
 public:
  using T = NumberOf<V>;

  Look(const Prepared<T>& scene, const Places<V>& places)
      : surfaces_(scene.surfaces.numbers.data()), finishes_(scene.finishes.numbers.data()), same_(places.same()) {
    if (same_) {
      surfaces_ += places.common() * surface_columns;
      finishes_ += static_cast<WholeOf<V>>(surfaces_[finish]) * finish_columns;
    } else {
      surface_ = shifted_left<std::countr_zero(unsigned{surface_columns})>(places.each());
      finish_ = shifted_left<std::countr_zero(unsigned{finish_columns})>(whole((*this)[finish]));
    }
  }

  Vec3<V> color() const { return {(*this)[red], (*this)[green], (*this)[blue]}; }

  RAYLAB_INLINE V operator[](FinishColumn column) const {
    return same_ ? V(finishes_[column]) : gather(finishes_ + column, finish_);
  }

 private:
  RAYLAB_INLINE V operator[](SurfaceColumn column) const {
    return same_ ? V(surfaces_[column]) : gather(surfaces_ + column, surface_);
  }

  const T *surfaces_, *finishes_;  ///< the tables, or the rows that are the same in all lanes
  bool same_;
  IndexOf<V> surface_, finish_;  ///< where the rows begin that differ
};

}  // namespace raylab::fast::RAYLAB_TARGET
