#include "EvalStream.h"

#include "PairRows.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Parallel.h>
#include <fmt/compile.h>

#include <atomic>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <iterator>
#include <mutex>

namespace fbrdf::tool {
namespace {

// Enough for three numbers of at most 16 characters and what is between them.
constexpr size_t kRowBytes = 80;

void appendCsv(const Vec3d& f, std::string& rows)
{
    char row[kRowBytes];
    const char* end = fmt::format_to(row, FMT_COMPILE("{:.9g},{:.9g},{:.9g}\n"), f.x, f.y, f.z);
    rows.append(row, static_cast<size_t>(end - row));
}

void appendJson(const Vec3d& f, std::string& rows)
{
    rows += rows.empty() ? "[" : ",\n[";
    for (int c = 0; c < 3; ++c)
        rows += (c > 0 ? "," : "") + (std::isfinite(f[c]) ? fmt::format("{:.9g}", f[c]) : "null");
    rows += ']';
}

// Takes the header line off the block that contains it, and skips blocks of comments alone.
PairRows takeHeader(LineBlocks& blocks, LineBlock& block)
{
    while (blocks.next(block)) {
        std::string_view rest = block.text;
        while (!rest.empty()) {
            const std::string_view line = takeLine(rest);
            const size_t number = block.firstLine++;
            if (isSkipped(line)) continue;
            const PairRows rows(line, blocks.where(number));
            block.text.erase(0, block.text.size() - rest.size());
            return rows;
        }
    }
    throw Error(ErrorKind::input, blocks.name(),
                Found("no line").expected("the header wo_x,wo_y,wo_z,wi_x,wi_y,wi_z"));
}

// Threads take blocks one after the other and hand in their rows in the order of taking.
class Pipeline {
public:
    Pipeline(LineBlocks& blocks, const EvalRequest& request)
        : blocks_(blocks), request_(request), rows_(takeHeader(blocks, first_))
    {
    }

    void work()
    {
        LineBlock block;
        std::string out;
        for (uint64_t ticket = 0; take(block, ticket);) {
            std::exception_ptr failure;
            try {
                out.clear();
                evaluateBlock(block, out);
            } catch (...) {
                failure = std::current_exception();
            }
            if (!handIn(ticket, out, failure)) return;
        }
    }

private:
    bool take(LineBlock& block, uint64_t& ticket)
    {
        const std::lock_guard<std::mutex> lock(input_);
        if (ended_) return false;
        ticket = taken_++;
        if (ticket == 0) {
            block = std::move(first_);
            return true;
        }
        try {
            ended_ = !blocks_.next(block);
        } catch (...) {  // thrown by handIn, after the rows of the blocks before this one
            ended_ = true;
            readFailure_ = std::current_exception();
            failedTicket_ = ticket;
            block.text.clear();
            return true;
        }
        return !ended_;
    }

    // Appends the rows up to the first bad one, then throws.
    void evaluateBlock(const LineBlock& block, std::string& out) const
    {
        std::string_view rest = block.text;
        DirectionPair<double> pair;
        for (size_t line = block.firstLine; !rest.empty(); ++line) {
            const std::string_view row = takeLine(rest);
            if (isSkipped(row)) continue;
            const std::string wrong = rows_.parse(row, pair);
            if (!wrong.empty()) throw Error(ErrorKind::input, blocks_.where(line), wrong);
            const Vec3d f = request_.brdf(pair.wo, pair.wi);
            if (request_.style == RowStyle::csv)
                appendCsv(f, out);
            else if (request_.style == RowStyle::number)
                fmt::format_to(std::back_inserter(out), FMT_COMPILE("{:.9g}\n"), f.x);
            else
                appendJson(f, out);
        }
    }

    // Writes the rows when all blocks before are written. Returns false when one of those failed.
    bool handIn(uint64_t ticket, const std::string& out, std::exception_ptr failure)
    {
        std::unique_lock<std::mutex> lock(output_);
        turn_.wait(lock, [&] { return stopped_ || written_ == ticket; });
        if (stopped_) return false;
        try {
            if (!out.empty()) request_.write(out);
            if (!failure && failedTicket_ == ticket) failure = readFailure_;
            if (failure) std::rethrow_exception(failure);
        } catch (...) {
            stopped_ = true;
            turn_.notify_all();
            throw;
        }
        ++written_;
        turn_.notify_all();
        return true;
    }

    static constexpr uint64_t kNone = ~uint64_t(0);

    LineBlocks& blocks_;
    const EvalRequest& request_;
    LineBlock first_;
    const PairRows rows_;

    std::mutex input_;
    uint64_t taken_ = 0;
    bool ended_ = false;
    std::exception_ptr readFailure_;
    std::atomic<uint64_t> failedTicket_{kNone};

    std::mutex output_;
    std::condition_variable turn_;
    uint64_t written_ = 0;
    bool stopped_ = false;
};

}  // namespace

void evaluateStream(LineBlocks& blocks, const EvalRequest& request)
{
    Pipeline pipeline(blocks, request);
    const auto threads = static_cast<size_t>(threadCount(request.threads));
    parallelTasks(threads, request.threads, [&](size_t) { pipeline.work(); });
}

}  // namespace fbrdf::tool
