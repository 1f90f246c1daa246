// The estimate, and the names of its constants.
#include "FormCost.h"

namespace tlgen {

double FormCost::estimate(const Operations &o, bool rows) const {
  return operation * double(o.adds + o.products - o.repeated) + repeated * double(o.repeated) + reciprocal * double(o.reciprocals) +
         function * double(o.functions) + vector * double(o.vectors) + iteration * double(o.iterations) + (rows ? form : 0);
}

const std::vector<FormCostConstant> &formCostConstants() {
  static const std::vector<FormCostConstant> all = {{"operation", &FormCost::operation},
                                                    {"repeated", &FormCost::repeated},
                                                    {"reciprocal", &FormCost::reciprocal},
                                                    {"function", &FormCost::function},
                                                    {"vector", &FormCost::vector},
                                                    {"iteration", &FormCost::iteration},
                                                    {"form", &FormCost::form}};
  return all;
}

} // namespace tlgen
