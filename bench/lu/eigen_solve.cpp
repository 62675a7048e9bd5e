#include <Eigen/Core>
#include <Eigen/LU>

#include "bench/lu/variants.hpp"

namespace tentpole {

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct EigenSolve::Memory {
  Eigen::PartialPivLU<RowMajorMatrix> factors;
};

EigenSolve::EigenSolve() : memory_(std::make_unique<Memory>()) {
  Eigen::setNbThreads(1);
}
EigenSolve::~EigenSolve() = default;

void EigenSolve::solve(const PatchSystems& systems, std::vector<double>& solution) {
  const int size = systems.system.size;
  memory_->factors.compute(Eigen::Map<const RowMajorMatrix>(systems.scaled.data(), size, size));
  const Eigen::Map<const Eigen::VectorXd> scale(systems.scale.data(), size), rhs(systems.system.rhs.data(), size);
  const Eigen::VectorXd scaled_rhs = rhs.cwiseProduct(scale);
  solution.resize(size);
  Eigen::Map<Eigen::VectorXd>(solution.data(), size) = memory_->factors.solve(scaled_rhs).cwiseProduct(scale);
}

}  // namespace tentpole
