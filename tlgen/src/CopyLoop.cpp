// for (i = 0; i < n; i++) to[i] = from[i], built node by node.
#include "CopyLoop.h"

namespace tlgen {
namespace {

class CopyLoop {
public:
  CopyLoop(Program &program, const Loc &loc) : program_(program), loc_(loc), size_(integer("unsigned long")), truth_(integer("int")) {}

  Stmt *build(Expr *to, Expr *from, Expr *count, bool overlap) {
    Stmt *block = statement(Stmt::Block);
    to_ = local(block, "tl_to", firstElement(to));
    from_ = from ? local(block, "tl_from", firstElement(from)) : nullptr;
    n_ = local(block, "tl_n", count);
    if (!from || !overlap) return block->body.push_back(loop(false)), block;
    Stmt *direction = statement(Stmt::If);
    direction->expr = node(Expr::Binary, truth_, {ref(to_), ref(from_)}, "<");
    direction->then = loop(false);
    direction->otherwise = loop(true);
    return block->body.push_back(direction), block;
  }

private:
  const Type *integer(const char *name) {
    Type t;
    t.kind = Type::Integer;
    t.name = name;
    return program_.make(std::move(t));
  }

  Expr *node(Expr::Kind kind, const Type *type, std::vector<Expr *> args, const std::string &text = "") {
    Expr n;
    n.kind = kind;
    n.type = type;
    n.loc = loc_;
    n.args = std::move(args);
    n.text = text;
    return program_.make(std::move(n));
  }

  Stmt *statement(Stmt::Kind kind) {
    Stmt s;
    s.kind = kind;
    s.loc = loc_;
    return program_.make(std::move(s));
  }

  const Variable *local(Stmt *block, const char *name, Expr *init) {
    Variable v;
    v.name = name;
    v.type = init->type;
    v.loc = loc_;
    Stmt *declare = statement(Stmt::Declare);
    declare->var = program_.make(std::move(v));
    declare->expr = init;
    block->body.push_back(declare);
    return declare->var;
  }

  Expr *ref(const Variable *v) {
    Expr *e = node(Expr::Ref, v->type, {});
    e->var = v;
    return e;
  }

  Expr *number(long n) { return node(Expr::Literal, size_, {}, std::to_string(n) + "ul"); }

  Expr *decay(Expr *array) {
    Type p;
    p.kind = Type::Pointer;
    p.element = array->type->element;
    return node(Expr::Decay, program_.make(std::move(p)), {array});
  }

  // The first number or struct behind a pointer, as a pointer to it: a[0] where a is an array of arrays.
  Expr *firstElement(Expr *pointer) {
    while (pointer->type->element->kind == Type::Array) {
      Expr *object = pointer->kind == Expr::AddressOf ? pointer->args[0] : node(Expr::Deref, pointer->type->element, {pointer});
      pointer = decay(object);
    }
    return pointer;
  }

  Expr *zero(const Type *type) {
    if (type->kind != Type::Struct) return node(Expr::Literal, type, {}, type->kind == Type::Real ? "0.0" : "0");
    return node(Expr::InitList, type, std::vector<Expr *>(type->record->fields.size()), "compound");
  }

  Stmt *loop(bool backwards) {
    Stmt *head = statement(Stmt::Block), *s = statement(Stmt::For);
    const Variable *i = local(head, "tl_i", backwards ? ref(n_) : number(0));
    const Type *element = to_->type->element;
    auto index = [&] { return backwards ? node(Expr::Binary, size_, {ref(i), number(1)}, "-") : ref(i); };
    Expr *value = from_ ? node(Expr::Index, element, {ref(from_), index()}) : zero(element);
    s->init = head;
    s->expr = node(Expr::Binary, truth_, {ref(i), backwards ? number(0) : ref(n_)}, backwards ? ">" : "<");
    s->step = node(Expr::Step, size_, {ref(i)}, backwards ? "--" : "++");
    s->then = statement(Stmt::Evaluate);
    s->then->expr = node(Expr::Assign, element, {node(Expr::Index, element, {ref(to_), index()}), value}, "=");
    s->then->expr->wholesale = true;
    return s;
  }

  Program &program_;
  Loc loc_;
  const Type *size_, *truth_;
  const Variable *to_ = nullptr, *from_ = nullptr, *n_ = nullptr;
};

} // namespace

Stmt *copyLoop(Program &program, const Loc &loc, Expr *to, Expr *from, Expr *count, bool overlap) {
  return CopyLoop(program, loc).build(to, from, count, overlap);
}

} // namespace tlgen
