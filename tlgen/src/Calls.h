// What a call in the source reaches: a function of math.h, an external function with a rule, the copy of an object, or functions of the
// sources, through pointers too where those are settled before run time. Subset and Lower both go by it. One of the files that see
// Clang.
#ifndef TLGEN_CALLS_H
#define TLGEN_CALLS_H

#include "Match.h"
#include "MathFunctions.h"

#include "clang/AST/Expr.h"

#include <optional>

namespace tlgen {

// A function together with the functions that its function pointer parameters are: each such instance is a function of its own in the
// program, so that no function pointer is left in it.
struct Instance {
  const clang::FunctionDecl *function = nullptr;
  std::vector<const clang::FunctionDecl *> bound; // one per parameter, null for those that are no function pointers

  bool operator<(const Instance &o) const { return std::tie(function, bound) < std::tie(o.function, o.bound); }
};

// A function by itself: one that is bound to no others.
inline Instance plainInstance(const clang::FunctionDecl *f) { return {f, std::vector<const clang::FunctionDecl *>(f->getNumParams())}; }

// Of the function and those it is bound to; the same name for different functions of several files.
std::string instanceName(const Instance &instance);

// How many arguments an external function with a rule may have.
const unsigned maxRuleArguments = 4;

// memcpy, memmove or memset of whole objects: element by element.
struct BulkCopy {
  const clang::Expr *to = nullptr, *from = nullptr; // pointers as written; from is null for zeros
  clang::QualType element;
  const clang::Expr *factor = nullptr; // elements: number, times factor where there is one
  long number = 0;
  long bytes = 0; // of an element, where factor counts bytes: the size of an array of variable length
  bool overlap = false;
};

struct Reach {
  // Same: its first argument's value, as __builtin_expect. Nothing: __builtin_unreachable. Generic: of tgmath.h.
  enum Kind { Math, Rule, Copy, Function, Choice, Same, Nothing, NotFinite, Generic, OtherTypes, NoBody, Unsettled } kind = Unsettled;
  const clang::FunctionDecl *callee = nullptr; // Math, Rule, Copy, NoBody
  std::string rule;                            // Rule: the function that fills the Taylor coefficients
  std::optional<BulkCopy> copy;                // Copy: none where the size is not one of whole objects
  Instance instance;                           // Function
  const clang::Expr *choice = nullptr;         // Choice: an index of options, or
  bool choiceIsCondition = false;              // a condition between two of them
  std::vector<Reach> options;                  // Choice: Math, Rule or Function
};

class Calls {
public:
  Calls(const Source &source, const Match &match, const Instance &caller);

  Reach reach(const clang::CallExpr *call) const;
  // True where an expression has the same value throughout the function; members are taken for constant where that is said.
  bool isSteady(const clang::Stmt *e, bool members = false) const;
  // True where what the expression names or holds is a function.
  static bool isFunctionPointer(clang::QualType type) { return type->isFunctionPointerType(); }
  // True for NULL, whatever it is made of.
  static bool isNull(const clang::Expr *e, const clang::ASTContext &context);

private:
  struct Settled {
    const clang::Expr *choice = nullptr;
    bool isCondition = false;
    std::vector<const clang::Expr *> values; // empty: not settled
  };
  Reach reachFunction(const clang::FunctionDecl *callee, const clang::CallExpr *call) const;
  Settled settle(const clang::Expr *e) const;
  Settled objects(const clang::Expr *lvalue) const;
  const clang::FunctionDecl *function(const clang::Expr *e) const;
  bool keepsValue(const clang::VarDecl *v) const;

  const Source &source_;
  const Match &match_;
  const Instance &caller_;
  std::set<const clang::VarDecl *> changed_;
  std::map<std::string, int> names_; // of parameters and locals: how many have it
};

} // namespace tlgen

#endif
