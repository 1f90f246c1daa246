// Emits one variant of a function as readable calls on libtaylor's jets: the heart of the calls emitter.
//
// A number that is active in the source is a jet in the output: ncoef consecutive tl_real. An active array is the jets of its elements
// one behind the other, an active pointer is a tl_real pointer that moves by whole jets. Everything passive stays the C it was. Each
// active local lives in a frame of jets that the function takes from the context on entry and gives back on return.
#ifndef TLGEN_EMITFUNCTION_H
#define TLGEN_EMITFUNCTION_H

#include "Activity.h"
#include "PrintC.h"

#include <set>

namespace tlgen {

// What a function takes from the frame stack by itself, in jets, and whom it calls.
struct Frame {
  long fixed = 0;
  std::vector<const Variable *> arrays; // of variable length
  std::vector<std::pair<const Expr *, const Variant *>> calls;
  std::map<const Variable *, const Expr *> constants; // locals that keep the value they are declared with
};

// Names of the variants in the output, and their frames.
struct Emitted {
  std::map<const Variant *, std::string> names;
  std::map<const Variant *, Frame> frames;
  bool severalFiles = false;
  std::set<std::string> absolutes; // of abs, labs and llabs those that are called
};

// Where a jet stands: a pointer, and how many jets behind it.
struct Address {
  std::string base;
  std::vector<std::pair<Text, Text>> terms; // index and jets per index

  std::string offset() const;  // "3*nc", "(i*4 + j)*nc"; empty for none
  std::string pointer() const; // base + offset
  std::string value() const;   // base[offset]
};

class FunctionEmitter {
public:
  FunctionEmitter(const Program &program, const Variant &variant, Emitted &emitted);
  // The whole definition; records the frame in emitted.
  std::string run();

private:
  // Signature and frame
  std::string signature();
  std::string nothing() const;
  std::string parameter(size_t i);
  void copyParameters();
  static std::string slot(long number);
  std::string jetDeclaration(const Type *type, const std::string &name) const;
  bool needsCopy(size_t i) const;
  void survey(const Stmt *s);
  void survey(const Expr *e, bool read);
  void surveyLengths(const Type *type);

  // Statements
  void statements(const std::vector<Stmt *> &list);
  void statement(const Stmt *s);
  void declare(const Stmt *s);
  void initObject(const std::string &base, const Type *type, const Expr *e);
  void constants(const std::string &base, const Type *type, const Text &text);
  void copyObject(const std::string &dest, const std::string &source, const Type *type);
  void evaluate(const Expr *e);
  Text assign(const Expr *e);
  void update(const std::string &x, const Expr *e);
  Text changeInteger(const Expr *e);
  static Text integerAt(const Type *type, const std::string &place);
  Text step(const Expr *e);
  void stepAt(const std::string &x, const Expr *e);
  std::string effect(const Expr *e);
  bool isAlone(const Expr *lhs, const Expr *factor) const;
  void branch(const Stmt *s);
  void loop(const Stmt *s);
  void emitLoop(const Stmt *s);
  void generalLoop(const Stmt *s);
  void choose(const Stmt *s);
  void choice(const Stmt *s, const Stmt *before);
  void leave(bool loopOnly);
  void variableArray(const Variable *var);
  void placeLocal(const Variable *var);
  void body(const Stmt *s);
  void returns(const Stmt *s);
  bool sincosPair(const Stmt *first, const Stmt *second);

  // Expressions: the C text of a value, the address of a jet, a jet computed into a place
  Text value(const Expr *e);
  Text callValue(const Expr *e);
  Text conditionalValue(const Expr *e);
  Text condition(const Expr *e);
  Text logicalValue(const Expr *e);
  Text pointer(const Expr *e);
  Text pointerValue(const Expr *e);
  Address place(const Expr *lvalue);
  std::string address(const Expr *lvalue);
  Text fixedAddress(const Expr *lvalue);
  std::string jet(const Expr *e);
  void into(const std::string &dest, const Expr *e);
  void binaryInto(const std::string &dest, const Expr *e);
  void mathInto(const std::string &dest, const Expr *e);
  void ruleInto(const std::string &dest, const Expr *e);
  std::string callText(const Expr *e, const std::string &dest);
  bool needsStatements(const Expr *e) const;
  static bool hasEffect(const Expr *e);
  bool isJet(const Expr *e) const { return v_.varied(e); }
  void round(const std::string &x);
  bool narrows(const Expr *cast) const;
  bool activeObject(const Expr *lvalue) const;
  bool activeInteger(const Expr *e) const;
  bool isObject(const Expr *e) const;
  bool activePointer(const Expr *e) const;

  // Output
  void line(const std::string &text);
  void operation(const std::string &name, const std::string &args);
  void quote(const Loc &loc);
  void tellLine(const Loc &loc);
  std::string temporary();
  std::string temporary(const Type *type);
  std::string fresh(const std::string &stem);
  std::string inputName(const Variable *param) const;
  std::string nameOf(const Variable *v) const;
  static std::string nameOf(const Stmt *label);
  std::string pointerList(const Expr *list);
  std::string passiveDeclaration(const Type *type, std::string name);
  void term(Address &a, const Expr *index, const Type *element);
  static void offset(Address &a, long jets);
  Text jetCount(const Type *type);

  const Program &program_;
  const Variant &v_;
  Emitted &emitted_;
  std::string out_;
  int indent_ = 1;
  long slots_ = 0; // jets of named locals
  int temporaries_ = 0, temporariesUsed_ = 0, freshNames_ = 0;
  Frame frame_;
  struct Scope {
    enum Kind { Plain, Loop, Switch } kind;
    std::string mark; // where the frame stack stood, in a block with arrays of variable length
  };
  std::vector<Scope> scopes_;
  bool hoist_ = false; // locals are placed at the top, since jumps may pass their declarations
  std::string hoisted_;
  std::map<const Variable *, std::string> renamed_;
  std::set<std::string> hoistedNames_, targets_; // targets_: labels that a goto names
  Loc quoted_;
  bool lineLost_ = false; // to a function that was called since
  bool writesThroughPointer_ = false;
  std::set<const Variable *> assigned_, addressTaken_, read_;
};

} // namespace tlgen

#endif
