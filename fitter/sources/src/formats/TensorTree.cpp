#include "formats/TensorTree.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

/// Each level halves the cube, and no direction is known to 2^-24.
constexpr int kDeepestTree = 24;
constexpr double kBelowOne = 1.0 - 1e-12;

bool separates(char c)
{
    return c == ' ' || c == ',' || c == '\n' || c == '\t' || c == '\r' || c == ';';
}

/// Position in the square of a point of the unit disc, each component in [0, 1).
std::array<double, 2> squareFromDisc(double x, double y)
{
    const double radius = std::min(std::hypot(x, y), 1.0);
    double phi = std::atan2(y, x);
    if (phi < -kPi / 4) phi += 2.0 * kPi;
    const int quarter = static_cast<int>((phi + kPi / 4) / (kPi / 2)) % 4;
    const double along = (phi - double(quarter) * kPi / 2) * radius / (kPi / 4);
    const std::array<std::array<double, 2>, 4> corner = {
        {{radius, along}, {-along, radius}, {-radius, -along}, {along, -radius}}};
    const auto toUnit = [](double v) { return std::clamp(0.5 * (v + 1.0), 0.0, kBelowOne); };
    return {toUnit(corner[size_t(quarter)][0]), toUnit(corner[size_t(quarter)][1])};
}

}  // namespace

/// Reads nodes from left to right.
class TensorTree::Parser {
public:
    Parser(const InputFile& file, std::string_view text, TensorTree& tree)
        : file_(file), all_(text), rest_(text), tree_(tree)
    {
    }

    void readTree()
    {
        readNode(0);
        skip();
        if (!rest_.empty()) fail(Found("more after the tree").expected("its end"));
    }

private:
    [[noreturn]] void fail(const std::string& what) const
    {
        throw inputError(file_, what + " at character " +
                                    std::to_string(all_.size() - rest_.size()) +
                                    " of ScatteringData");
    }
    void skip()
    {
        while (!rest_.empty() && separates(rest_.front())) rest_.remove_prefix(1);
    }
    char peek()
    {
        skip();
        return rest_.empty() ? '\0' : rest_.front();
    }
    void take(char c)
    {
        if (peek() != c)
            fail(Found(rest_.empty() ? "the end" : inQuotes(rest_.substr(0, 1)))
                     .expected(inQuotes(std::string(1, c))));
        rest_.remove_prefix(1);
    }

    /// Index of the node.
    uint32_t readNode(int depth)
    {
        if (depth > kDeepestTree) fail(Found("a tree of more than 24 levels").expected("fewer"));
        const auto index = static_cast<uint32_t>(tree_.nodes_.size());
        tree_.nodes_.emplace_back();
        take('{');
        if (peek() == '{')
            readBranches(index, depth);
        else
            readValues(index);
        take('}');
        return index;
    }
    void readBranches(uint32_t index, int depth)
    {
        std::vector<uint32_t> children;
        for (int i = 0; i < 1 << tree_.rank_; ++i) children.push_back(readNode(depth + 1));
        tree_.nodes_[index].first = static_cast<uint32_t>(tree_.children_.size());
        tree_.children_.insert(tree_.children_.end(), children.begin(), children.end());
    }
    void readValues(uint32_t index)
    {
        const size_t first = tree_.values_.size();
        for (char c = peek(); c != '}' && c != '\0'; c = peek()) tree_.values_.push_back(number());
        const size_t count = tree_.values_.size() - first;
        int log2 = 0;
        while (log2 < 20 && size_t(1) << (tree_.rank_ * log2) < count) ++log2;
        if (count != size_t(1) << (tree_.rank_ * log2))
            fail(Found(std::to_string(count) + " values in a leaf")
                     .expected("a power of " + std::to_string(1 << tree_.rank_)));
        tree_.nodes_[index] = {log2, static_cast<uint32_t>(first)};
    }
    float number()
    {
        size_t end = 0;
        while (end < rest_.size() && !separates(rest_[end]) && rest_[end] != '}' &&
               rest_[end] != '{')
            ++end;
        double value = 0.0;
        if (!parseNumber(rest_.substr(0, end), value) || !(std::abs(value) < 3e38))
            fail(Found(inQuotes(rest_.substr(0, std::max<size_t>(end, 1))))
                     .expected("a finite number"));
        rest_.remove_prefix(end);
        return static_cast<float>(value);
    }

    const InputFile& file_;
    std::string_view all_, rest_;
    TensorTree& tree_;
};

TensorTree::TensorTree(const InputFile& file, std::string_view text, int rank) : rank_(rank)
{
    Parser(file, text, *this).readTree();
}

double TensorTree::lookUp(Point at) const
{
    const Node* node = &nodes_.front();
    while (node->log2Grid < 0) {
        size_t branch = 0;
        for (size_t i = 0; i < size_t(rank_); ++i) {
            at[i] *= 2.0;
            if (at[i] < 1.0) continue;
            at[i] -= 1.0;
            branch |= size_t(1) << i;
        }
        node = &nodes_[children_[node->first + branch]];
    }
    size_t index = 0;
    for (size_t i = 0; i < size_t(rank_); ++i)
        index = index << node->log2Grid |
                static_cast<size_t>(at[i] * double(size_t(1) << node->log2Grid));
    return double(values_[node->first + index]);
}

double TensorTree::operator()(const Vec3d& wo, const Vec3d& wi) const
{
    if (rank_ == 4) {
        const auto in = squareFromDisc(-wi.x, -wi.y), out = squareFromDisc(wo.x, wo.y);
        return lookUp({in[0], in[1], out[0], out[1]});
    }
    const double radius = std::hypot(wi.x, wi.y);
    const double c = radius > 0.0 ? -wi.x / radius : 1.0, s = radius > 0.0 ? -wi.y / radius : 0.0;
    const auto out = squareFromDisc(c * wo.x + s * wo.y, c * wo.y - s * wo.x);
    return lookUp({std::clamp(0.5 - 0.5 * radius, 0.0, 0.5 * kBelowOne), out[0], out[1], 0.0});
}

double TensorTree::meanOf(const Node& node) const
{
    const size_t count =
        node.log2Grid < 0 ? size_t(1) << rank_ : size_t(1) << (rank_ * node.log2Grid);
    double sum = 0.0;
    for (size_t i = 0; i < count; ++i)
        sum += node.log2Grid < 0 ? meanOf(nodes_[children_[node.first + i]])
                                 : double(values_[node.first + i]);
    return sum / double(count);
}

double TensorTree::mean() const
{
    return meanOf(nodes_.front());
}

}  // namespace fbrdf
