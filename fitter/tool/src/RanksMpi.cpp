#include "Ranks.h"

#include <mpi.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace fbrdf::tool {

bool startedByMpirun()
{
    return std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMI_SIZE");
}

Ranks::Ranks()
{
    if (!startedByMpirun()) return;
    int given = 0;  // only this thread calls MPI; where that is not granted nothing else would be
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &given);
    joined_ = true;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    MPI_Comm machine;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &machine);
    MPI_Comm_size(machine, &onThisMachine_);
    MPI_Comm_free(&machine);
}

Ranks::~Ranks()
{
    if (joined_) MPI_Finalize();
}

std::string Ranks::broadcast(const std::string& text) const
{
    if (!joined_) return text;
    std::string all = text;
    unsigned long long size = all.size();
    MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG_LONG, 0, MPI_COMM_WORLD);
    all.resize(static_cast<size_t>(size));
    MPI_Bcast(all.data(), static_cast<int>(size), MPI_CHAR, 0, MPI_COMM_WORLD);
    return all;
}

std::string Ranks::gather(const std::string& text) const
{
    if (!joined_) return text;
    int size = static_cast<int>(text.size());
    std::vector<int> sizes(static_cast<size_t>(count_)), offsets(sizes.size());
    MPI_Gather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
    std::exclusive_scan(sizes.begin(), sizes.end(), offsets.begin(), 0);
    std::string all;
    if (rank_ == 0) all.resize(static_cast<size_t>(offsets.back() + sizes.back()));
    MPI_Gatherv(text.data(), size, MPI_CHAR, all.data(), sizes.data(), offsets.data(), MPI_CHAR, 0,
                MPI_COMM_WORLD);
    return all;
}

void Ranks::sum(double* values, size_t count) const
{
    constexpr size_t kMost = size_t{1} << 26;  // a message: MPI counts in int
    for (size_t from = 0; joined_ && from < count; from += kMost)
        MPI_Allreduce(MPI_IN_PLACE, values + from, static_cast<int>(std::min(kMost, count - from)),
                      MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
}

}  // namespace fbrdf::tool
