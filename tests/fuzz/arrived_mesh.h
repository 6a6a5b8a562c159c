// What must hold of bytes that were sent as a mesh, whoever sent them.
#pragma once

#include "lessons/scene/file/shape_text.h"
#include "widgets/mesh_files/make_shape.h"
#include "widgets/mesh_files/mesh_wire.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace halfspace {

inline void require(bool holds) {
  if (!holds)
    std::abort();
}

/// A mesh that can be asked for hits, or a sentence.
inline void requireMeshOrSentence(std::string_view bytes, std::size_t pieceSize) {
  MeshDecoder decoder;
  for (std::size_t at = 0; at < bytes.size(); at += pieceSize)
    decoder.feed(bytes.substr(at, pieceSize));
  decoder.finish();
  require(decoder.isDone() != decoder.problem().has_value());
  if (!decoder.isDone()) {
    require(!decoder.problem()->sentence.empty());
    return;
  }
  RawMesh raw = decoder.take();
  const std::size_t all = raw.triangles.size();
  const std::atomic<bool> cancelled = false;
  const auto mesh = makeShape(std::move(raw), "fuzz", cancelled, [](std::optional<double>) {});
  if (!mesh) {
    require(!mesh.problem().sentence.empty());
    return;
  }
  require(mesh->triangles > 0 && mesh->triangles + mesh->degenerate + mesh->repeated + mesh->broken == all);
  const auto [corners, faces] = written(*mesh->shape);
  require(static_cast<bool>(readShape(corners, faces)));
  (void)mesh->shape->search()->search({{0, 0, 1}, {1, 2, 3}});
}

} // namespace halfspace
