#include "core/synthesis/search_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/synthesis/search_kernels.cpp"
#ifndef HWY_WANT_AVX3_DL
#define HWY_WANT_AVX3_DL 1
// AVX-512 without VNNI was slower than AVX2 where it was measured, and SSSE3 is as fast as SSE4.
#define HWY_DISABLED_TARGETS (HWY_AVX3 | HWY_SSSE3)
#endif
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
#undef CHIARO_KERNEL
namespace chiaro::synthesis::kernels::HWY_NAMESPACE {

// Highway 1.0.3 names the 256-bit VNNI where it asks for the 512-bit one.
#if HWY_TARGET == HWY_AVX3_DL
#define CHIARO_KERNEL __attribute__((target("avx512vnni")))
#else
#define CHIARO_KERNEL
#endif

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<std::int32_t, columnPadding>;
using Vector = hn::Vec<Lanes>;
constexpr Lanes lanes;

// Candidate rows whose sums are held in registers at once, of 32 or of 16 registers.
#if HWY_TARGET == HWY_AVX3_DL
constexpr int rowsAtOnce = 16;
#else
constexpr int rowsAtOnce = 6;
#endif
static_assert(rowsAtOnce <= rowPadding);

HWY_INLINE Vector loadQuads(const std::uint32_t* quads) {
    return hn::LoadU(lanes, reinterpret_cast<const std::int32_t*>(quads));
}

HWY_INLINE Vector broadcast(std::uint32_t quad) {
    return hn::Set(lanes, static_cast<std::int32_t>(quad));
}

#if HWY_TARGET == HWY_AVX3_DL

// Four products a lane and their sum in one instruction.
template <int length>
CHIARO_KERNEL HWY_INLINE void addPiece(Vector (&sums)[rowsAtOnce], const std::uint32_t* quads,
                                       std::ptrdiff_t rowPitch, const TemplatePiece& piece) {
    Vector factors[length];
#pragma GCC unroll 8
    for (int i = 0; i < length; ++i) factors[i] = broadcast(piece.quads[std::size_t(i)]);
#pragma GCC unroll 32
    for (int y = 0; y < rowsAtOnce + length - 1; ++y) {
        const Vector source = loadQuads(quads + y * rowPitch);
#pragma GCC unroll 8
        for (int i = 0; i < length; ++i)
            if (y - i >= 0 && y - i < rowsAtOnce)
                sums[y - i].raw = _mm512_dpbusd_epi32(sums[y - i].raw, source.raw, factors[i].raw);
    }
}

#elif HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4

// 127 * 63 * 4 fits into 16 bits, so two rows of the template are added up before they are widened.
HWY_INLINE Vector products(Vector source, Vector factor) {
#if HWY_TARGET == HWY_AVX2
    return Vector{_mm256_maddubs_epi16(source.raw, factor.raw)};
#else
    return Vector{_mm_maddubs_epi16(source.raw, factor.raw)};
#endif
}

HWY_INLINE Vector addHalves(Vector a, Vector b) {
    const hn::Repartition<std::int16_t, Lanes> halves;
    return hn::BitCast(lanes, hn::Add(hn::BitCast(halves, a), hn::BitCast(halves, b)));
}

HWY_INLINE Vector widened(Vector sums) {
#if HWY_TARGET == HWY_AVX2
    return Vector{_mm256_madd_epi16(sums.raw, _mm256_set1_epi16(1))};
#else
    return Vector{_mm_madd_epi16(sums.raw, _mm_set1_epi16(1))};
#endif
}

template <int length>
CHIARO_KERNEL HWY_INLINE void addPiece(Vector (&sums)[rowsAtOnce], const std::uint32_t* quads,
                                       std::ptrdiff_t rowPitch, const TemplatePiece& piece) {
#pragma GCC unroll 4
    for (int i = 0; i + 1 < length; i += 2) {
        const Vector upper = broadcast(piece.quads[std::size_t(i)]);
        const Vector lower = broadcast(piece.quads[std::size_t(i + 1)]);
        Vector source = loadQuads(quads + i * rowPitch);
#pragma GCC unroll 16
        for (int y = 0; y < rowsAtOnce; ++y) {
            const Vector below = loadQuads(quads + (i + 1 + y) * rowPitch);
            const Vector pair = addHalves(products(source, upper), products(below, lower));
            sums[y] = hn::Add(sums[y], widened(pair));
            source = below;
        }
    }
    if constexpr (length % 2 == 1) {
        const Vector factor = broadcast(piece.quads[std::size_t(length - 1)]);
#pragma GCC unroll 16
        for (int y = 0; y < rowsAtOnce; ++y) {
            const Vector source = loadQuads(quads + (length - 1 + y) * rowPitch);
            sums[y] = hn::Add(sums[y], widened(products(source, factor)));
        }
    }
}

#else

// Any other processor: a byte at a time in 32 bits.
template <int byte>
HWY_INLINE Vector byteProduct(Vector source, Vector factor) {
    const hn::RebindToUnsigned<Lanes> bits;
    const auto positive = hn::ShiftRight<24>(hn::ShiftLeft<24 - 8 * byte>(hn::BitCast(bits, source)));
    const auto negatable = hn::ShiftRight<24>(hn::ShiftLeft<24 - 8 * byte>(factor));
    return hn::Mul(hn::BitCast(lanes, positive), negatable);
}

template <int length>
CHIARO_KERNEL HWY_INLINE void addPiece(Vector (&sums)[rowsAtOnce], const std::uint32_t* quads,
                                       std::ptrdiff_t rowPitch, const TemplatePiece& piece) {
    for (int i = 0; i < length; ++i) {
        const Vector factor = broadcast(piece.quads[std::size_t(i)]);
        for (int y = 0; y < rowsAtOnce; ++y) {
            const Vector source = loadQuads(quads + (i + y) * rowPitch);
            const Vector even = hn::Add(byteProduct<0>(source, factor), byteProduct<2>(source, factor));
            const Vector odd = hn::Add(byteProduct<1>(source, factor), byteProduct<3>(source, factor));
            sums[y] = hn::Add(sums[y], hn::Add(even, odd));
        }
    }
}

#endif

// All pieces of one length, for a vector of candidates in each of rowsAtOnce rows.
template <int length>
CHIARO_KERNEL HWY_NOINLINE void addPieces(std::int32_t* HWY_RESTRICT totals, const std::uint32_t* quads,
                                          std::ptrdiff_t rowPitch, std::span<const TemplatePiece> pieces) {
    const auto stride = std::ptrdiff_t(hn::Lanes(lanes));
    Vector sums[rowsAtOnce];
#pragma GCC unroll 16
    for (int y = 0; y < rowsAtOnce; ++y) sums[y] = hn::Load(lanes, totals + y * stride);
    for (const TemplatePiece& piece : pieces) addPiece<length>(sums, quads + piece.offset, rowPitch, piece);
#pragma GCC unroll 16
    for (int y = 0; y < rowsAtOnce; ++y) hn::Store(sums[y], lanes, totals + y * stride);
}

using AddPieces = void (*)(std::int32_t*, const std::uint32_t*, std::ptrdiff_t,
                           std::span<const TemplatePiece>);
constexpr AddPieces addPiecesOfLength[longestPiece] = {addPieces<1>, addPieces<2>, addPieces<3>,
                                                       addPieces<4>, addPieces<5>, addPieces<6>,
                                                       addPieces<7>, addPieces<8>};

// Turns the sums of products into costs.
HWY_INLINE void finishCosts(const CostRequest& request, int column, int row, const std::int32_t* totals) {
    const hn::RebindToUnsigned<Lanes> bits;
    const auto stride = std::ptrdiff_t(hn::Lanes(lanes));
    for (int y = 0; y < rowsAtOnce; ++y) {
        const std::uint32_t* squares =
            request.source.squares + (request.y + row + y) * request.source.squaresPitch + request.x + column;
        auto cost = hn::Set(bits, request.constant);
        for (const SquaresRectangle& rectangle : request.rectangles) {
            const auto bottom = hn::Sub(hn::LoadU(bits, squares + rectangle.bottomRight),
                                        hn::LoadU(bits, squares + rectangle.bottomLeft));
            const auto top = hn::Sub(hn::LoadU(bits, squares + rectangle.topRight),
                                     hn::LoadU(bits, squares + rectangle.topLeft));
            cost = hn::Add(cost, hn::Sub(bottom, top));
        }
        const auto cross = hn::BitCast(bits, hn::Load(lanes, totals + y * stride));
        cost = hn::Sub(cost, hn::Add(cross, cross));
        hn::StoreU(cost, bits, request.costs + (row + y) * request.pitch + column);
    }
}

void computeCosts(const CostRequest& request) {
    const int stride = int(hn::Lanes(lanes));
    const std::ptrdiff_t rowPitch = 3 * request.source.quadPitch;
    HWY_ALIGN std::int32_t totals[rowsAtOnce * columnPadding];
    for (int row = 0; row < request.rows; row += rowsAtOnce)
        for (int column = 0; column < request.columns; column += stride) {
            const std::uint32_t* quads =
                request.source.quads + (request.y + row) * rowPitch + request.x + column;
            std::fill(std::begin(totals), std::end(totals), 0);
            for (int i = 0; i < longestPiece; ++i)
                if (const auto pieces = request.pieces[std::size_t(i)]; !pieces.empty())
                    addPiecesOfLength[i](totals, quads, rowPitch, pieces);
            finishCosts(request, column, row, totals);
        }
}

std::uint32_t smallestCost(const std::uint32_t* costs, std::ptrdiff_t pitch, int columns, int rows) {
    const hn::RebindToUnsigned<Lanes> bits;
    const int stride = int(hn::Lanes(bits));
    auto smallest = hn::Set(bits, ~std::uint32_t{0});
    std::uint32_t rest = ~std::uint32_t{0};
    for (int row = 0; row < rows; ++row) {
        const std::uint32_t* line = costs + row * pitch;
        int column = 0;
        for (; column + stride <= columns; column += stride)
            smallest = hn::Min(smallest, hn::LoadU(bits, line + column));
        for (; column < columns; ++column) rest = std::min(rest, line[column]);
    }
    return std::min(rest, hn::GetLane(hn::MinOfLanes(bits, smallest)));
}

void collectCosts(const std::uint32_t* costs, std::ptrdiff_t pitch, int columns, int rows,
                  std::uint32_t limit, std::vector<std::uint32_t>& places) {
    const hn::RebindToUnsigned<Lanes> bits;
    const int stride = int(hn::Lanes(bits));
    const auto limits = hn::Set(bits, limit);
    for (int row = 0; row < rows; ++row) {
        const std::uint32_t* line = costs + row * pitch;
        for (int column = 0; column < columns; column += stride) {
            // What lies past the last column only costs a closer look.
            const auto values = hn::LoadU(bits, line + column);
            if (hn::AllFalse(bits, hn::Eq(hn::Min(values, limits), values))) continue;
            for (int i = column; i < std::min(column + stride, columns); ++i)
                if (line[i] <= limit) places.push_back(std::uint32_t(row * columns + i));
        }
    }
}

}  // namespace chiaro::synthesis::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <string_view>

namespace chiaro::synthesis::kernels {

HWY_EXPORT(computeCosts);
HWY_EXPORT(smallestCost);
HWY_EXPORT(collectCosts);

void computeCosts(const CostRequest& request) {
    HWY_DYNAMIC_DISPATCH(computeCosts)(request);
}

std::uint32_t smallestCost(const std::uint32_t* costs, std::ptrdiff_t pitch, int columns, int rows) {
    return HWY_DYNAMIC_DISPATCH(smallestCost)(costs, pitch, columns, rows);
}

void collectCosts(const std::uint32_t* costs, std::ptrdiff_t pitch, int columns, int rows,
                  std::uint32_t limit, std::vector<std::uint32_t>& places) {
    HWY_DYNAMIC_DISPATCH(collectCosts)(costs, pitch, columns, rows, limit, places);
}

std::vector<const char*> supportedTargets() {
    onlyUseTarget(nullptr);
    std::vector<const char*> names;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        names.push_back(hwy::TargetName(target));
    return names;
}

void onlyUseTarget(const char* name) {
    hwy::SetSupportedTargetsForTest(0);
    if (name)
        for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
            if (std::string_view(hwy::TargetName(target)) == name) hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace chiaro::synthesis::kernels

#endif
