// How many jets a call of a model function takes from the frame stack at most, its callees included.
#ifndef TLGEN_FRAMEBOUND_H
#define TLGEN_FRAMEBOUND_H

#include "EmitFunction.h"

namespace tlgen {

// A sum of a constant and of C expressions in the model's parameters.
struct Bound {
  long fixed = 0;
  std::vector<std::string> terms; // in order; one for each array
  std::string text() const;       // "12 + 3*(size_t)p->n"
  bool usesParams() const;
};

class FrameBound {
public:
  FrameBound(const Emitted &emitted, const Program &program, const Model &model, Diagnostics &diags)
      : emitted_(emitted), program_(program), model_(model), diags_(diags) {}

  // For a model function; its parameter struct is called p in the terms. Lengths that do not follow from it are reported.
  Bound of(const Variant *root, const std::vector<Arg> &args);

private:
  using Environment = std::map<const Variable *, std::string>; // what integer arguments are, in terms of p
  Bound bound(const Variant *v, const Environment &env);
  bool expand(const Expr *e, const Environment &env, const Frame &frame, std::string &text) const;
  bool expandLength(const Type *type, const Environment &env, const Frame &frame, std::string &text) const;

  const Emitted &emitted_;
  const Program &program_;
  const Model &model_;
  Diagnostics &diags_;
  std::vector<const Variant *> stack_;
};

} // namespace tlgen

#endif
