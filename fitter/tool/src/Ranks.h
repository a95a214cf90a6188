// Ranks.h - the processes that share a batch or a data set: those of `mpirun`, or this one alone.
// Reference: MPI 3.1 standard; OpenMPI sets OMPI_COMM_WORLD_SIZE for what it starts.
#pragma once
#include <cstddef>
#include <string>

namespace fbrdf::tool {

class Ranks {
public:
    /// Joins the processes of mpirun where the environment names them. In a program that was built
    /// without MPI it throws Error(usage) there, because every process would do all of the work.
    Ranks();
    ~Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    int rank() const { return rank_; }    ///< 0 .. count() - 1
    int count() const { return count_; }  ///< >= 1
    int onThisMachine() const { return onThisMachine_; }

    /// Returns the text of rank 0 on every rank. All ranks must call it.
    std::string broadcast(const std::string& text) const;
    /// Returns the texts of all ranks in their order on rank 0, and nothing on the others. All
    /// ranks must call it.
    std::string gather(const std::string& text) const;
    /// Replaces the values on every rank by their sums over all ranks. All ranks must call it.
    void sum(double* values, size_t count) const;

private:
    int rank_ = 0, count_ = 1, onThisMachine_ = 1;
    bool joined_ = false;
};

/// True when mpirun started this process.
bool startedByMpirun();

}  // namespace fbrdf::tool
