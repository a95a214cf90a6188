// Ranks.h where MPI was not found: one process.
#include "Ranks.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <cstdlib>

namespace fbrdf::tool {

bool startedByMpirun()
{
    return std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMI_SIZE");
}

Ranks::Ranks()
{
    if (startedByMpirun())
        throw Error(
            ErrorKind::usage, "mpirun",
            Found("a fbrdf that was built without MPI").expected("one built with libopenmpi-dev"));
}

Ranks::~Ranks() = default;

std::string Ranks::broadcast(const std::string& text) const
{
    return text;
}

std::string Ranks::gather(const std::string& text) const
{
    return text;
}

void Ranks::sum(double*, size_t) const {}

}  // namespace fbrdf::tool
