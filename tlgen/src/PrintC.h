// C text: declarators and expressions with as few parentheses as compilers accept without a warning.
#ifndef TLGEN_PRINTC_H
#define TLGEN_PRINTC_H

#include "Program.h"

namespace tlgen {

// Binding strength of C operators, strongest first.
enum Precedence {
  Primary = 16,
  Postfix = 15,
  Prefix = 14,
  Product = 12,
  Sum = 11,
  Shift = 10,
  Relation = 9,
  Equality = 8,
  BitAnd = 7,
  BitXor = 6,
  BitOr = 5,
  And = 4,
  Or = 3,
  Choice = 2,
  Assignment = 1,
  Sequence = 0
};

struct Text {
  std::string s;
  int precedence = Primary;
};

// The text as an operand that must bind at least so strongly.
std::string operand(const Text &t, int least);

// a op b, and op a.
Text binaryText(const std::string &op, const Text &a, const Text &b);
Text unaryText(const std::string &op, const Text &a);
int precedenceOf(const std::string &binaryOperator);

// The shortest decimal that reads back as the same number: "0.5", "2.0", "1e-300".
std::string decimal(double value);

// Generated code computes in tl_real wherever the source says double, so that one text serves every number type that real.h offers: its
// constants are "TL_C(0.5)", and "-TL_C(2.0)" where they are negative,
std::string realConstant(const std::string &decimal);
std::string realConstant(double value);
// and so are the source's own literals of type double; others are as they were.
Text literalText(const Expr *e);
// A call of math.h, "TL_LIBM(sin)(x)"; of what is no function of doubles there, "isnan(x)", "fabsf(x)".
Text mathText(const std::string &name, const std::string &args);
// How long a text is to a reader, to whom "TL_C(0.5)" is a number and "TL_LIBM(sin)" a name.
size_t readLength(const std::string &text);
// A call of an external function, which keeps its doubles: "(tl_real)spring((double)x)".
Text externalText(const std::string &name, const std::vector<Text> &args);

// The declaration of name with that type, without a semicolon: "const tl_real *x", "int a[3]".
std::string declaration(const Type *type, const std::string &name);

// A struct's definition, members on lines of their own.
std::string definition(const Record *record);

// The standard headers that definitions need, as lines: members of types that C++ spells otherwise have names that both know.
std::string includesOf(const std::vector<const Record *> &records);

// A literal or initialiser list without active values.
std::string initializer(const Expr *e);

// The initialiser of an object of zeros, all members named: compilers warn where one leaves some out.
std::string zeroValue(const Type *type);

// What stands for an item that an initialiser list of that type leaves out.
std::string zeroItem(const Type *type, size_t i);

// How many numbers an object of the type holds: 1, or those of all elements of an array or members of a struct. Not for one of variable
// length.
long elements(const Type *type);
bool variableLength(const Type *type);

// How many numbers stand before a member of a struct, and whether all members are numbers, or arrays or structs of them.
long fieldOffset(const Record *record, const std::string &field);
bool allNumbers(const Type *type);

inline bool isSingle(const Type *type) { return type->kind == Type::Real && type->name == "float"; }

// True for a number and for an array or struct: what a pointer in the output points to as jets. False for pointers and arrays of them.
bool holdsNumbers(const Type *type);

// A source line as it can stand inside a comment: without its own comments, no trailing backslash, tabs as blanks.
std::string commentText(std::string text);

} // namespace tlgen

#endif
