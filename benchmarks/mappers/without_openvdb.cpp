#include "mappers/mapper.hpp"

namespace rmap::bench {

std::vector<Contender> openvdb_contenders() { return {}; }

}  // namespace rmap::bench
