#pragma once

#include "core/export/placed_surface.h"

namespace chiaro::exporting {

/// Stands for "no group".
inline constexpr std::uint32_t noGroup = 0xFFFFFFFF;

/// For each face the group of the plan whose view a chart shows it from: the one that faces it best, but that
/// faces go with most of their neighbours where another view sees them nearly as well, and that specks go
/// with what surrounds them. noGroup for a face that is in no group.
std::vector<std::uint32_t> chartGroups(const PlacedSurface& surface);

/// Faces that hang together.
using Piece = std::vector<std::uint32_t>;

/// The connected pieces of the faces with area among `faces`, two neighbours being connected when `alike`
/// says so. Pieces begin in the order of `faces`; each lists its faces breadth first.
std::vector<Piece> connectedPieces(const PlacedSurface& surface, const std::vector<std::uint32_t>& faces,
                                   const std::function<bool(std::uint32_t, std::uint32_t)>& alike);

}  // namespace chiaro::exporting
