#pragma once

#include "core/export/placed_surface.h"

namespace chiaro::exporting {

/// Stands for "no group".
inline constexpr std::uint32_t noGroup = 0xFFFFFFFF;

/// Faces that hang together, and the group of the plan whose view shows (most of) them best.
struct Piece {
    std::vector<std::uint32_t> faces;
    std::uint32_t group = noGroup;  ///< noGroup for faces that are in none
};

/// Takes a surface apart as its views see it: each face with area goes to the view that faces it best, but
/// that faces go with most of their neighbours where another view sees them nearly as well, and that specks
/// go with what surrounds them where they look about the same way. Deterministic.
std::vector<Piece> chartPieces(const PlacedSurface& surface);

/// The least cosine between a face's normal and the direction that a chart shows it from.
inline constexpr double leastFacing = 0.4;

/// Tells which faces hang together. Its memory serves any number of questions, each of which takes as long as
/// there are faces in it, however large the surface is.
class FaceConnector {
public:
    explicit FaceConnector(const PlacedSurface& surface)
        : m_surface(surface), m_isOpen(surface.faceCount(), false) {}

    /// The connected parts of these faces, which have area; two neighbours are connected when `alike` says
    /// so. Parts begin in the order of `faces`, each is in the order of a search in breadth.
    template <class Alike>
    std::vector<std::vector<std::uint32_t>> parts(const std::vector<std::uint32_t>& faces, Alike alike) {
        for (const std::uint32_t face : faces) m_isOpen[face] = true;
        std::vector<std::vector<std::uint32_t>> parts;
        for (const std::uint32_t first : faces) {
            if (!m_isOpen[first]) continue;
            m_isOpen[first] = false;
            std::vector<std::uint32_t>& part = parts.emplace_back(1, first);
            for (std::size_t i = 0; i < part.size(); ++i)
                for (const std::uint32_t other : m_surface.neighbours(part[i])) {
                    if (!m_isOpen[other] || !alike(part[i], other)) continue;
                    m_isOpen[other] = false;
                    part.push_back(other);
                }
        }
        return parts;
    }

private:
    const PlacedSurface& m_surface;
    std::vector<bool> m_isOpen;
};

}  // namespace chiaro::exporting
