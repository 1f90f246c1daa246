// Activity: which storage holds values that depend on the coordinates, the velocities or the time (varied values).
//
// The analysis is insensitive to the order of statements: a variable that is ever given a varied value is active throughout, an array
// is active as a whole. Pointers are followed by unification: what two pointers may both point to is one place. A function is analysed
// once for each pattern of active arguments it is called with; each such variant is emitted by itself.
#ifndef TLGEN_ACTIVITY_H
#define TLGEN_ACTIVITY_H

#include "Diagnostics.h"
#include "Program.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace tlgen {

// A class of storage that is active or passive together. Follow with find().
struct Place {
  bool active = false;
  bool written = false;
  bool input = false;  // constants: may not be written
  bool frozen = false; // constants: may not become active
  Place *parent = nullptr;
  Place *target = nullptr;               // what a pointer stored here points to
  std::map<std::string, Place *> fields; // pointer members of a struct; its numbers are one place, the struct itself
};
Place *find(Place *p);

// One function under one pattern of active arguments.
class Variant {
public:
  const Function *function = nullptr;
  // One letter per parameter: a active, p passive; of a model function also i for an active input and c for constants (no writing
  // there).
  std::string signature;
  std::map<const Variable *, Place *> places;
  Place *result = nullptr;
  std::map<const Expr *, Variant *> callees;
  std::map<const Expr *, Place *> literals; // storage of compound literals

  bool active() const { return signature.find_first_of("ai") != std::string::npos || find(result)->active; }
  bool activeParam(size_t i) const { return signature[i] == 'a' || signature[i] == 'i'; }
  bool active(const Variable *v) const;     // the variable's numbers, or what it points to
  bool varied(const Expr *e) const;         // a number or struct that depends on the inputs
  bool pointsToActive(const Expr *e) const; // a pointer to active numbers
  Place *place(const Expr *lvalue) const;   // storage of an lvalue; null for a temporary
  Place *target(const Expr *pointer) const; // storage that a pointer value points to; null where unknown
};

class Activity {
public:
  Activity(const Program &program, const Model &model, Diagnostics &diags);
  ~Activity();

  // The variant of each model function, in the model's order.
  const std::vector<Variant *> &roots() const { return roots_; }
  // All variants, callees before callers.
  const std::vector<Variant *> &variants() const { return order_; }

private:
  friend class VariantAnalysis;
  Variant *variant(const Function *f, const std::string &signature);
  Place *makePlace(const Type *type);
  void report(const char *id, const Loc &loc, const std::string &what);

  const Program &program_;
  Diagnostics &diags_;
  std::vector<std::unique_ptr<Place>> storage_;
  std::vector<std::unique_ptr<Variant>> owned_;
  std::map<std::pair<const Function *, std::string>, Variant *> known_;
  std::map<const Variable *, Place *> globals_;
  std::vector<Variant *> roots_, order_;
};

} // namespace tlgen

#endif
