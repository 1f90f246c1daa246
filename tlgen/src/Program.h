// The intermediate program: plain data between the lowering of Clang's tree and the analyses and emitters.
//
// Every node keeps its source location. Nodes are owned by the Program and never freed before it, so plain pointers link them.
#ifndef TLGEN_PROGRAM_H
#define TLGEN_PROGRAM_H

#include <deque>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace tlgen {

struct Expr;
struct Function;
struct Record;
struct Rule;
struct Stmt;

// A place in the source. file indexes Program::files and paths; line and column count from 1, and line 0 means no place.
struct Loc {
  int file = -1;
  unsigned line = 0, column = 0;
};

struct Type {
  enum Kind { Void, Integer, Real, Pointer, Array, Struct } kind = Void;
  std::string name;              // Integer and Real: the C spelling
  const Type *element = nullptr; // Pointer, Array
  long count = 0;                // Array: number of elements, 0 where length says it
  const Expr *length = nullptr;  // Array of variable length
  const Record *record = nullptr;
  bool isConst = false;
};

struct Field {
  std::string name;
  const Type *type;
  Loc loc;
};

struct Record {
  std::string spelling; // as a type name: "struct pendulum", "pendulum_t"
  std::string tag;      // after "struct", empty for an anonymous one behind a typedef
  std::vector<Field> fields;
  Loc loc;
};

struct Variable {
  enum Scope { Local, Parameter, Global } scope = Local;
  std::string name;
  const Type *type = nullptr;
  Loc loc;
  const Expr *init = nullptr; // Global tables, and locals that are static const
  bool isStatic = false;
};

struct Expr {
  enum Kind {
    Literal,     // text
    Ref,         // var
    Index,       // args[0][args[1]]
    Member,      // args[0].text, or -> where arrow
    Deref,       // *args[0]
    AddressOf,   // &args[0]
    Decay,       // an array as a pointer to its first element
    Unary,       // text args[0]
    Binary,      // args[0] text args[1], comparisons and && || included
    Conditional, // args[0] ? args[1] : args[2]
    Call,        // callee(args)
    MathCall,    // text(args): a function of math.h, or an external one with a rule
    Cast,        // (type)args[0], written or implied
    Assign,      // args[0] text args[1], text "=", "+=", ...
    Step,        // text is "++" or "--", before where prefix
    Comma,       // args[0], args[1]
    InitList     // {args}; a null argument is a zero; text is "compound" for a compound literal, which names its type
  } kind = Literal;
  const Type *type = nullptr;
  Loc loc;
  std::string text;
  std::vector<Expr *> args;
  const Variable *var = nullptr;
  Function *callee = nullptr;
  const Rule *rule = nullptr;
  bool arrow = false, prefix = false;
  bool wholesale = false; // Assign: of a copy of storage, a value or not
};

struct Stmt {
  // Case (expr null: default), Label and Goto stand between the statements of their Block.
  enum Kind { Block, Declare, Evaluate, If, While, DoWhile, For, Switch, Case, Label, Goto, Break, Continue, Return } kind = Block;
  Loc loc;
  std::vector<Stmt *> body;      // Block
  const Variable *var = nullptr; // Declare
  Expr *expr = nullptr;          // Declare: initialiser; If, Switch and loops: condition; Evaluate; Return; Case: its value
  std::string label;             // Label, Goto
  Expr *step = nullptr;          // For
  Stmt *init = nullptr;          // For: a Block of declarations or an Evaluate
  Stmt *then = nullptr, *otherwise = nullptr; // If; loops and Switch keep their body in then
};

struct Function {
  std::string name;
  const Type *result = nullptr;
  std::vector<const Variable *> params;
  Stmt *body = nullptr;
  Loc loc;
};

// An external function of numbers, and the function that fills its Taylor coefficients.
struct Rule {
  std::string function, taylor;
  size_t arity;
};

// What a function of the model is for.
enum class Role { Lagrangian, Force, Dissipation, Holonomic, Nonholonomic };

// Whether its result is one number.
inline bool isScalar(Role role) { return role == Role::Lagrangian || role == Role::Dissipation; }

// What a parameter of such a function is.
enum class ArgRole { Q, Qd, T, Params, Out };

// One parameter: an array of coordinates, or the single coordinate number index (from 0).
struct Arg {
  ArgRole role;
  int index = -1; // -1: all of them, and for other roles
};

// A count that is a constant or an integer member of the parameter struct.
struct Count {
  long value = 0;
  std::string member; // empty: the constant
};

struct ModelFunction {
  Role role;
  Function *function = nullptr;
  std::vector<Arg> args; // one per parameter
  Count rows;
};

struct Model {
  std::string name;
  Count dof;
  std::vector<ModelFunction> functions;
  const Record *params = nullptr;              // null where no function takes parameters
  std::map<const Function *, Count> recursion; // how deep functions that call themselves may go
};

class Program {
public:
  std::vector<std::string> paths;                // of the files, as the user gave them
  std::vector<std::string> files;                // their names as quoted in output: without folders
  std::vector<std::vector<std::string>> sources; // their lines
  std::vector<const Record *> records;           // in the order of definition
  std::vector<const Variable *> globals;
  std::vector<Function *> functions; // callees before callers
  std::map<std::string, Rule> rules; // of external functions, by name
  std::set<std::string> names;       // of all variables and functions, as they are printed

  std::deque<Variable> &variables() { return vars_; }

  Type *make(Type t) { return &types_.emplace_back(std::move(t)); }
  Expr *make(Expr e) { return &exprs_.emplace_back(std::move(e)); }
  Stmt *make(Stmt s) { return &stmts_.emplace_back(std::move(s)); }
  Variable *make(Variable v) { return &vars_.emplace_back(std::move(v)); }
  Function *make(Function f) { return &funcs_.emplace_back(std::move(f)); }
  Record *make(Record r) { return &recs_.emplace_back(std::move(r)); }

private:
  std::deque<Type> types_;
  std::deque<Expr> exprs_;
  std::deque<Stmt> stmts_;
  std::deque<Variable> vars_;
  std::deque<Function> funcs_;
  std::deque<Record> recs_;
};

} // namespace tlgen

#endif
