// Included by RowKernelBaseline.cpp and RowKernelAvx2.cpp with FBRDF_ROW_KERNELS naming what they
// define.
namespace fbrdf {
namespace {

using Index = std::ptrdiff_t;

// Vector types make the lanes of one number explicit: the compiler would not vectorise them by
// itself, as sums may overlap entries for all that it can prove. How such values travel depends on
// the instruction set, so locals are passed by reference and numbers in arrays by pointer: clang
// takes it that a reference which a function gets or returns is aligned to the whole vector.
// Members of a class, as template arguments lose their attributes.
struct OneLane {
    typedef double Value;
};
struct FourLanes {
    typedef double Value __attribute__((vector_size(32), aligned(8), may_alias));
    typedef float Floats __attribute__((vector_size(16), aligned(4), may_alias));
    typedef int Ints __attribute__((vector_size(16), aligned(4), may_alias));
    typedef unsigned Words __attribute__((vector_size(16), aligned(4), may_alias));
};
using Four = FourLanes::Value;
using FourFloats = FourLanes::Floats;
using FourInts = FourLanes::Ints;
using FourWords = FourLanes::Words;

Four* lanesAt(double* numbers, Index index)
{
    return reinterpret_cast<Four*>(numbers) + index;
}
const Four* lanesAt(const double* numbers, Index index)
{
    return reinterpret_cast<const Four*>(numbers) + index;
}
void widen(const float* lanes, Four& wide)
{
    wide = __builtin_convertvector(*reinterpret_cast<const FourFloats*>(lanes), Four);
}

FourFloats* lanesAt(float* numbers, Index index)
{
    return reinterpret_cast<FourFloats*>(numbers) + index;
}
const FourFloats* lanesAt(const float* numbers, Index index)
{
    return reinterpret_cast<const FourFloats*>(numbers) + index;
}

// 2^x, x = n + f with n whole and |f| <= 1/2: the series of 2^f to f^7, which leaves 6e-9 of it. x
// is cut off at +-126, where floats are still normal.
void exp2Of(const FourFloats& exponent, FourFloats& result)
{
    constexpr float kMost = 126.0f, kWhole = 12582912.0f;  // 1.5 2^23: adding it rounds to whole
    const FourFloats most = FourFloats{} + kMost;
    FourFloats x = exponent < most ? exponent : most;
    x = x > -most ? x : -most;
    const FourFloats shifted = x + kWhole, f = x - (shifted - kWhole);
    const FourWords n = reinterpret_cast<const FourWords&>(shifted) << 23;
    FourFloats sum = 1.5252734e-5f * f + 1.5403530e-4f;
    sum = sum * f + 1.3333558e-3f;
    sum = sum * f + 9.6181291e-3f;
    sum = sum * f + 5.5504109e-2f;
    sum = sum * f + 2.4022651e-1f;
    sum = sum * f + 6.9314718e-1f;
    sum = sum * f + 1.0f;
    reinterpret_cast<FourWords&>(result) = reinterpret_cast<const FourWords&>(sum) + n;
}

// log2 x of normal x = 2^n m, m in [sqrt(1/2), sqrt(2)): log2 m = 2 / ln 2 artanh s, s = (m - 1) /
// (m + 1); the series to s^9 leaves 3e-10.
void log2Of(const FourFloats& x, FourFloats& result)
{
    constexpr int kRootHalf = 0x3f3504f3, kMantissa = 0x007fffff;
    const FourInts bits = reinterpret_cast<const FourInts&>(x) - kRootHalf,
                   mantissa = (bits & kMantissa) + kRootHalf;
    const FourFloats m = reinterpret_cast<const FourFloats&>(mantissa), s = (m - 1.0f) / (m + 1.0f),
                     square = s * s;
    FourFloats sum = 0.32059889f * square + 0.41219858f;
    sum = sum * square + 0.57707802f;
    sum = sum * square + 0.96179669f;
    sum = sum * square + 2.8853901f;
    result = __builtin_convertvector(bits >> 23, FourFloats) + s * sum;
}

void log2(float* numbers, Index count)
{
    const Index whole = count - count % kRowLanes;
    FourFloats last = FourFloats{} + 1.0f;
    for (Index i = 0; i < whole; i += kRowLanes) {
        FourFloats lanes = *lanesAt(numbers + i, 0);
        log2Of(lanes, lanes);
        *lanesAt(numbers + i, 0) = lanes;
    }
    for (Index i = whole; i < count; ++i) last[i - whole] = numbers[i];
    log2Of(last, last);
    for (Index i = whole; i < count; ++i) numbers[i] = last[i - whole];
}

void predictRow(const KernelRows& rows, Index i, const KernelTexels& texels, FourFloats& logG,
                float* share)
{
    const int* unknown = rows.unknown + i * rows.width;
    const float* weight = rows.weight + i * rows.width;
    FourFloats sum{};
    Index k = 0;
    for (Index t = 0; t < rows.terms; ++t) {
        logG = *lanesAt(texels.levels, t);
        for (; k < rows.termEnd[t]; ++k) logG += weight[k] * *lanesAt(texels.values, unknown[k]);
        if (rows.terms == 1) return;
        FourFloats part;
        exp2Of(logG, part);
        *lanesAt(share, t) = part;
        sum += part;
    }
    for (Index t = 0; t < rows.terms; ++t) *lanesAt(share, t) /= sum;
    log2Of(sum, logG);
}

void predict(const KernelRows& rows, const KernelTexels& texels, float* logG, float* share)
{
    for (Index i = 0; i < rows.count; ++i) {
        FourFloats sum;
        predictRow(rows, i, texels, sum, share + i * rows.terms * kRowLanes);
        *lanesAt(logG, i) = sum;
    }
}

// b of one row.
template <class E>
void fillEntries(const KernelRows& rows, Index i, typename E::Value* entry)
{
    using Entry = typename E::Value;
    const float* weight = rows.weight + i * rows.width;
    if (!rows.share) {
        for (Index k = 0; k < rows.width; ++k) entry[k] = Entry{} + static_cast<double>(weight[k]);
        return;
    }
    const float* share = rows.share + i * rows.terms * kRowLanes;
    Index k = 0;
    for (Index t = 0; t < rows.terms; ++t, share += kRowLanes) {
        Entry part;
        if constexpr (sizeof(Entry) == sizeof(Four))
            widen(share, part);
        else
            part = static_cast<double>(*share);
        for (; k < rows.termEnd[t]; ++k) entry[k] = part * static_cast<double>(weight[k]);
    }
}

bool counts(const KernelRows& rows, Index i)
{
    const float* weight = rows.sampleWeight + i * kRowLanes;
    return rows.group[i] != kNoGroup &&
           (weight[0] > 0.0f || weight[1] > 0.0f || weight[2] > 0.0f || weight[3] > 0.0f);
}

// Adds factor b for the entries [from, to) that `counts` to a line of sums whose first belongs to
// unknown `first`.
template <class S, class E, class Counts>
void addLine(typename S::Value* line, Index first, const typename S::Value& factor,
             const int* unknown, const typename E::Value* entry, Index from, Index to,
             const Counts& counts)
{
    for (Index k = from; k < to; ++k)
        if (counts(unknown[k])) line[unknown[k] - first] += factor * entry[k];
}

template <class S, class E>
void addMatrix(const KernelRows& rows, const int* unknown, const typename E::Value* entry,
               const typename S::Value& weight, const KernelSums& sums, typename S::Value* matrix)
{
    using Sum = typename S::Value;
    const Index first = rows.bandedFirst, last = rows.bandedLast, banded = sums.banded,
                line = sums.bandwidth, borders = banded * (line + 1),
                denses = borders + banded * sums.dense;
    const auto every = [](Index) { return true; };
    for (Index a = first; a < last; ++a) {
        const Index u = unknown[a];
        const Sum factor = weight * entry[a];
        addLine<S, E>(matrix + u * line + line, 0, factor, unknown, entry, first, last,
                      [u](Index column) { return column <= u; });
        Sum* border = matrix + borders + u * sums.dense;
        addLine<S, E>(border, banded, factor, unknown, entry, 0, first, every);
        addLine<S, E>(border, banded, factor, unknown, entry, last, rows.width, every);
    }
    for (Index a = 0; a < rows.width; ++a) {
        if (a >= first && a < last) continue;
        const Index u = unknown[a];
        const Sum factor = weight * entry[a];
        Sum* dense = matrix + denses + (u - banded) * sums.dense;
        const auto below = [u](Index other) { return other >= u; };
        addLine<S, E>(dense, banded, factor, unknown, entry, 0, first, below);
        addLine<S, E>(dense, banded, factor, unknown, entry, last, rows.width, below);
    }
}

// MatrixLanes: 0, 1 or kRowLanes.
template <int MatrixLanes, class E>
void addRows(const KernelRows& rows, const KernelSums& sums, typename E::Value* entry)
{
    for (Index i = 0; i < rows.count; ++i) {
        if (!counts(rows, i)) continue;
        const int* unknown = rows.unknown + i * rows.width;
        fillEntries<E>(rows, i, entry);
        Four weight, residual;
        widen(rows.sampleWeight + i * kRowLanes, weight);
        widen(rows.residual + i * kRowLanes, residual);
        if constexpr (MatrixLanes == 1)
            addMatrix<OneLane, E>(rows, unknown, entry, weight[0], sums,
                                  sums.matrix[rows.group[i]]);
        if constexpr (MatrixLanes == kRowLanes)
            addMatrix<FourLanes, E>(rows, unknown, entry, weight, sums,
                                    lanesAt(sums.matrix[rows.group[i]], 0));
        const Four pull = weight * residual;
        addLine<FourLanes, E>(lanesAt(sums.right[rows.group[i]], 0), 0, pull, unknown, entry, 0,
                              rows.width, [](Index) { return true; });
    }
}

void add(const KernelRows& rows, const KernelSums& sums, int entryLanes, int matrixLanes,
         double* scratch)
{
    if (entryLanes == kRowLanes)
        addRows<kRowLanes, FourLanes>(rows, sums, lanesAt(scratch, 0));
    else if (matrixLanes == 0)
        addRows<0, OneLane>(rows, sums, scratch);
    else if (matrixLanes == 1)
        addRows<1, OneLane>(rows, sums, scratch);
    else
        addRows<kRowLanes, OneLane>(rows, sums, scratch);
}

template <class E>
void applyRows(const KernelRows& rows, const double* p, double* result, typename E::Value* entry)
{
    for (Index i = 0; i < rows.count; ++i) {
        if (!counts(rows, i)) continue;
        const int* unknown = rows.unknown + i * rows.width;
        fillEntries<E>(rows, i, entry);
        Four along{}, weight;
        for (Index k = 0; k < rows.width; ++k) along += entry[k] * *lanesAt(p, unknown[k]);
        widen(rows.sampleWeight + i * kRowLanes, weight);
        along *= weight;
        addLine<FourLanes, E>(lanesAt(result, 0), 0, along, unknown, entry, 0, rows.width,
                              [](Index) { return true; });
    }
}

void apply(const KernelRows& rows, int entryLanes, const double* p, double* result, double* scratch)
{
    if (entryLanes == 1)
        applyRows<OneLane>(rows, p, result, scratch);
    else
        applyRows<FourLanes>(rows, p, result, lanesAt(scratch, 0));
}

template <class E>
void diagonalRows(const KernelRows& rows, double* const* sum, typename E::Value* entry)
{
    for (Index i = 0; i < rows.count; ++i) {
        if (!counts(rows, i)) continue;
        const int* unknown = rows.unknown + i * rows.width;
        fillEntries<E>(rows, i, entry);
        Four weight, residual;
        widen(rows.sampleWeight + i * kRowLanes, weight);
        widen(rows.residual + i * kRowLanes, residual);
        for (Index k = 0; k < rows.width; ++k) {
            typename E::Value all{};  // an unknown may stand in a row twice
            for (Index j = 0; j < rows.width; ++j)
                if (unknown[j] == unknown[k]) all += entry[j];
            const Four scaled = weight * entry[k];
            *lanesAt(sum[0], unknown[k]) += scaled * all;
            *lanesAt(sum[1], unknown[k]) += scaled * residual;
        }
    }
}

void diagonal(const KernelRows& rows, int entryLanes, double* const* sum, double* scratch)
{
    if (entryLanes == 1)
        diagonalRows<OneLane>(rows, sum, scratch);
    else
        diagonalRows<FourLanes>(rows, sum, lanesAt(scratch, 0));
}

}  // namespace

const RowKernels FBRDF_ROW_KERNELS = {log2, predict, add, apply, diagonal};

}  // namespace fbrdf
