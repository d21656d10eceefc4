#pragma once

#include "core/render/engine.hpp"

#include <memory>
#include <span>

namespace raylab {

/// The truth that all else is measured against: docs/model.md's formulas as printed, one scalar ray at a time, every
/// geometry asked. Slow: a tenth of a millisecond to some milliseconds a pixel, where a double takes a microsecond.
///
/// Each pixel is computed with 113 and with 237 bits. Where the two clamped colors agree to 1e-25 in every component, the
/// double nearest the finer one is returned. Where they do not (a sphere so far and small, or a decision between two
/// surfaces so close, that 113 bits cannot tell), the pixel is computed with 493 bits, which must agree with 237. Where they
/// do not either, the pixel is three quiet NaNs. What is tangent, tied or touching, exactly or to within 1e-111 of its
/// scale, is decided as docs/model.md says: see `sign` in number.hpp.
///
/// `scene` is copied. Rays are counted once, not once a precision. A ray that carries no light to the pixel, its weight or
/// the bounces left being 0, is neither traced nor counted; a shadow ray is counted for each point or directional light that
/// has L.N > 0.
std::unique_ptr<Engine> make_oracle(const Scene& scene, const Settings& settings);

/// A color, and the least and the greatest that are right too: over the shifts off the surface that docs/model.md accepts.
struct ColorRange {
  Color value, least, greatest;
};

/// All that the oracle says of a pixel. docs/tolerance.md explains what for.
struct PixelWord {
  ColorRange together;              ///< as the model has it; NaN where the precisions do not agree
  ColorRange each;                  ///< with each dot product clamped by itself, an accepted variant
  double margin = 1;                ///< the least slack of any decision on the pixel's ray tree, 0 to 1
  double sensitivity = 0;           ///< the most that a component moves when every ray of the tree is rounded to double
  GeometryId object = no_geometry;  ///< that the pixel's centre shows
};

/// An oracle that also writes its word on each pixel into `words`, as many as the image has pixels, in its order. It renders
/// every `every`-th pixel, evenly spread; the others stay as they are, and black.
std::unique_ptr<Engine> make_witness(const Scene& scene, const Settings& settings, std::span<PixelWord> words, int every);

/// Is this pixel among every `every`-th?
bool is_sampled(int column, int row, int every);

}  // namespace raylab
