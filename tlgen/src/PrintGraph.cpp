// C from a graph: expressions, statements, loops.
#include "PrintGraph.h"
#include "MathFunctions.h"
#include "Trace.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace tlgen {
namespace {

const size_t longestExpression = 100; // characters; what is longer is taken apart
const long longestLocal = 64;         // numbers of an array on the stack

std::string blanks(int n) { return std::string(size_t(n), ' '); }

bool isTruth(const Node *n) {
  return n->op == Node::Compare || (n->op == Node::Math && n->text == "tl_power_exists") || n->op == Node::Not ||
         n->op == Node::Conjunction || n->op == Node::Disjunction;
}

// Values whose text is as good as a name, wherever and however often it is used.
bool isPlain(const Node *n) {
  switch (n->op) {
  case Node::Number:
  case Node::Affine:
  case Node::Leaf:
  case Node::Carried:
  case Node::Final:
    return true;
  case Node::Convert:
    return isPlain(n->args[0]);
  default:
    return false;
  }
}

// Whether an argument of the function is an int.
bool takesInt(const std::string &function, size_t argument) {
  if (function == "ldexp" || function == "scalbn" || function == "scalbln") return argument == 1;
  return argument == 2 && (function == "tl_power" || function == "tl_power_exists");
}

// Whether there is a tl_lanes_ function of that name.
bool hasLanes(const std::string &function) {
  static const std::set<std::string> toIntegers = {"lround", "lrint", "llround", "llrint"};
  const MathFunction *f = findMath(function);
  const bool real = f && (f->kind == MathFunction::Smooth || f->kind == MathFunction::Step) && !toIntegers.count(f->name);
  return real || function.rfind("tl_power", 0) == 0;
}

bool isNegative(const Node *n) {
  return n->isNumber() ? n->value < 0 : n->op == Node::Mul && n->args[0]->isNumber() && n->args[0]->value < 0;
}

} // namespace

std::string numberText(double value) {
  char text[32];
  for (int digits = 1; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value) break;
  }
  std::string s = text;
  return s.find_first_of(".en") == std::string::npos ? s + ".0" : s;
}

size_t Sites::number(const Node *node) {
  std::string function = node->op == Node::Recip ? "div" : node->op == Node::Taylor ? "compose" : node->text;
  if (function == "tl_power") function = "pow";
  for (size_t i = 0; i < sites_.size(); ++i)
    if (sites_[i].function == function && sites_[i].loc.file == node->loc.file && sites_[i].loc.line == node->loc.line) return i + 1;
  sites_.push_back({function, node->loc});
  return sites_.size();
}

GraphPrinter::GraphPrinter(Schedule &schedule, const Program &program, Sites &sites, std::set<std::string> taken, bool lanes)
    : schedule_(schedule), program_(program), sites_(sites), taken_(std::move(taken)), lanes_(lanes) {}

// Whether the value may be another in each lane. What is in memory, or goes from one iteration to the next, always may.
bool GraphPrinter::inLanes(const Node *n) {
  if (!lanes_) return false;
  auto known = inLanes_.find(n);
  if (known != inLanes_.end()) return known->second;
  bool is = n->op == Node::Read || schedule_.place(n) != nullptr || (n->op == Node::Leaf && n->slot->kind != Slot::Member);
  if (n->op == Node::Carried || n->op == Node::Final) is = !isInteger(n->of->carried[size_t(n->which)].init);
  for (const Node *arg : n->args) is |= inLanes(arg);
  if (is) requireLanes(n);
  return inLanes_[n] = is;
}

// Lanes go through the same statements with other numbers: what decides on statements or places, and what is no arithmetic, may not
// depend on them.
void GraphPrinter::requireLanes(const Node *n) {
  auto refuse = [&](const std::string &why) { throw Unsuitable{why, n->loc}; };
  const std::string lanes = " depends on the state, which is another in each lane";
  for (size_t k = 0; k < n->args.size(); ++k) {
    if (!inLanes(n->args[k])) continue;
    const bool ofTruths =
        n->op == Node::Not || n->op == Node::Conjunction || n->op == Node::Disjunction || (n->op == Node::Select && k == 0);
    if (n->op == Node::Leaf || n->op == Node::Read) refuse("the place in an array" + lanes);
    if (n->op == Node::Convert || n->op == Node::Integer || (isInteger(n) && n->op == Node::Select)) refuse("an integer" + lanes);
    if (isTruth(n->args[k]) != ofTruths) refuse("a number that stands for a truth value" + lanes);
    if (n->op == Node::Taylor) refuse("an argument of a function with a rule" + lanes);
    if (n->op == Node::Math && (takesInt(n->text, k) || !hasLanes(n->text))) refuse("an argument of '" + n->text + "'" + lanes);
  }
}

// As an operand that must be lanes.
Text GraphPrinter::filled(const Node *n) { return lanes_ && !inLanes(n) ? Text{"tl_lanes_of(" + real(n).s + ")", Postfix} : real(n); }

std::string GraphPrinter::type(const Node *n) {
  if (isTruth(n)) return inLanes(n) ? "tl_mask" : "int";
  return isInteger(n) ? "long" : inLanes(n) ? "tl_lanes" : "tl_real";
}

std::string GraphPrinter::fresh(const std::string &wish) {
  std::string name = wish;
  for (int n = 2; !taken_.insert(name).second; ++n) name = wish + std::to_string(n);
  return name;
}

std::string GraphPrinter::arrayName(const Array *a) {
  std::string &name = arrayNames_[a];
  if (name.empty()) {
    name = fresh(a->name.empty() ? "kept" : a->name);
    declared_.push_back(a);
    if (a->length > longestLocal) workspace_ += padded(a->length);
  }
  return name;
}

std::string GraphPrinter::phase(size_t number) {
  blocks_ = schedule_.order(number);
  return block(nullptr, 2);
}

std::string GraphPrinter::declarations() const {
  std::string s;
  for (auto &[name, table] : tables_) s += "  static " + declaration(table->type, name) + " = " + initializer(table->init) + ";\n";
  long offset = 0;
  for (const Array *a : declared_) {
    const std::string &name = arrayNames_.at(a);
    if (a->length <= longestLocal) {
      s += "  " + number() + " " + name + "[" + std::to_string(a->length) + "];\n";
      continue;
    }
    s += "  " + number() + " *const restrict " + name + " = work + " + std::to_string(offset) + ";\n";
    offset += padded(a->length);
  }
  std::string outside;
  for (size_t site : failing_) outside += (outside.empty() ? "" : ", ") + ("outside" + std::to_string(site)) + " = 0";
  return s + (outside.empty() ? "" : "  int " + outside + ";\n");
}

long GraphPrinter::kept() const {
  long numbers = 0;
  for (const Array *a : declared_) numbers += a->length;
  return numbers;
}

std::string GraphPrinter::returnSite() const {
  std::string any, which;
  for (size_t site : failing_) {
    std::string number = std::to_string(site);
    any += (any.empty() ? "" : " | ") + ("outside" + number);
    which += site == *failing_.rbegin() ? number : "outside" + number + " ? " + number + " : ";
  }
  return any.empty() ? "" : "  if (" + any + ") return " + which + ";\n";
}

std::string GraphPrinter::block(const Loop *loop, int indent) {
  std::string s;
  auto at = blocks_.find(loop);
  if (at == blocks_.end()) return s;
  for (const Item &i : at->second) s += item(i, indent);
  return s;
}

std::string GraphPrinter::item(const Item &i, int indent) {
  switch (i.kind) {
  case Item::Value: {
    std::string s = value(i.node, indent);
    return schedule_.isKept(i.node) ? s + blanks(indent) + "(void)(" + show(i.node).text.s + ");\n" : s;
  }
  case Item::Repeat:
    return loopText(i.loop, indent);
  case Item::Leave:
    return blanks(indent) + element(i.array, i.write->index) + (i.array->summed ? " += " : " = ") + filled(i.write->value).s + ";\n";
  case Item::Start:
  case Item::Rows:
    return rows_ ? rows_(i.loop, i.kind == Item::Start, indent) : "";
  case Item::Evaluate:
    return batch(*i.batch, indent);
  case Item::Test:
    return check(*i.check, indent);
  case Item::Clear:
    return clear(i.array, indent);
  case Item::Condition:
    return blanks(indent) + "if (" + unaryText("!", show(i.loop->condition).text).s + ") break;\n";
  }
  return "";
}

bool GraphPrinter::mustBeNamed(const Node *n, const Shown &shown) const {
  if (isPlain(n)) return false;
  bool atomic = shown.text.s.find_first_of(" (") == std::string::npos;
  if (schedule_.place(n) || (n->op == Node::Mul && n->args[0]->is(-1) && atomic)) return false;
  return !schedule_.isUsedOnce(n) || shown.text.s.size() > longestExpression;
}

// Keeps the text of a value that is used once for its user; gives others a name.
std::string GraphPrinter::value(const Node *n, int indent) {
  std::string before = n->op == Node::Taylor ? external(n, indent) : "";
  Shown shown = compute(n);
  if (!mustBeNamed(n, shown)) {
    shown_[n] = shown;
    return before;
  }
  std::string name = n->name.empty() ? fresh("t" + std::to_string(++temporaries_)) : fresh(n->name);
  shown_[n] = {{name, Primary}, {}};
  return before + quote(n->loc, indent) + blanks(indent) + "const " + type(n) + " " + name + " = " + shown.text.s + ";\n";
}

std::string GraphPrinter::quote(const Loc &loc, int indent) {
  if (loc.file < 0 || !loc.line || (loc.file == quoted_.file && loc.line == quoted_.line)) return "";
  quoted_ = loc;
  const auto &lines = program_.sources[size_t(loc.file)];
  std::string s = program_.files[size_t(loc.file)] + ":" + std::to_string(loc.line);
  if (quotedBefore_.insert({loc.file, loc.line}).second && loc.line <= lines.size()) s += ": " + commentText(lines[loc.line - 1]);
  return blanks(indent) + "/* " + s + " */\n";
}

GraphPrinter::Shown GraphPrinter::show(const Node *n) {
  auto at = shown_.find(n);
  return at != shown_.end() ? at->second : compute(n);
}

// As an operand of real arithmetic: integers are converted first.
Text GraphPrinter::real(const Node *n) {
  Text t = show(n).text;
  if (n->isConstant()) return {numberText(double(n->offset)), Primary};
  return isInteger(n) ? Text{"(tl_real)" + operand(t, Prefix), Prefix} : t;
}

// What is added before what is taken away: 4 - i, 2*i + 1.
Text GraphPrinter::affine(const Node *n) {
  std::vector<std::pair<Text, bool>> parts; // true: to be taken away
  for (auto &[loop, factor] : n->terms) {
    Text name{indexNames_.at(loop), Primary}, times{std::to_string(std::labs(factor)) + "*" + name.s, Product};
    if (factor) parts.push_back({std::labs(factor) == 1 ? name : times, factor < 0});
  }
  if (n->offset || parts.empty()) parts.push_back({{std::to_string(std::labs(n->offset)), Primary}, n->offset < 0});
  auto added = std::find_if(parts.begin(), parts.end(), [](const auto &part) { return !part.second; });
  if (added != parts.end()) std::rotate(parts.begin(), added, added + 1);
  Text sum = parts[0].second ? unaryText("-", parts[0].first) : parts[0].first;
  for (size_t i = 1; i < parts.size(); ++i) sum = binaryText(parts[i].second ? "-" : "+", sum, parts[i].first);
  return sum;
}

std::string GraphPrinter::fill(const std::string &text, const std::vector<Text> &indices) {
  std::string s;
  size_t next = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      s += text[i];
      continue;
    }
    bool factor = (i > 0 && text[i - 1] == '*') || (i + 1 < text.size() && text[i + 1] == '*');
    const Text &t = indices[next++];
    s += factor ? operand(t, Product) : t.s;
  }
  return s;
}

std::string GraphPrinter::leaf(const Node *n) {
  static const std::map<Slot::Kind, const char *> texts = {
      {Slot::Q, "q[%]"},     {Slot::Qd, "qd[%]"},         {Slot::T, "t"},
      {Slot::Qdd, "qdd[%]"}, {Slot::Lambda, "lambda[%]"}, {Slot::Direction, "w[%*k + c]"}};
  auto known = texts.find(n->slot->kind);
  if (lanes_ && n->slot->kind == Slot::T) return "t[0]";
  const Variable *table = n->slot->variable;
  if (table && table->scope == Variable::Local) tables_[table->name] = table;
  std::vector<Text> indices;
  for (const Node *arg : n->args) indices.push_back(show(arg).text);
  return fill(known == texts.end() ? n->slot->text : known->second, indices);
}

std::string GraphPrinter::element(const Array *a, const Node *at) {
  auto known = bound_.find(a);
  if (known == bound_.end()) return arrayName(a) + "[" + index(at) + "]";
  const Binding &b = known->second;
  if (std::count(b.lvalue.begin(), b.lvalue.end(), '%') == 1) return fill(b.lvalue, {show(at).text});
  Text columns{std::to_string(b.columns), Primary};
  if (at->op != Node::Affine) return fill(b.lvalue, {binaryText("/", show(at).text, columns), binaryText("%", show(at).text, columns)});
  Node row = *at, column = *at;
  row.offset = at->offset / b.columns, column.offset = at->offset % b.columns;
  for (size_t i = 0; i < at->terms.size(); ++i) {
    bool ofRow = at->terms[i].second % b.columns == 0;
    row.terms[i].second = ofRow ? at->terms[i].second / b.columns : 0;
    column.terms[i].second = ofRow ? 0 : at->terms[i].second;
  }
  return fill(b.lvalue, {affine(&row), affine(&column)});
}

void GraphPrinter::bind(const Array *a, const std::string &lvalue, long columns) { bound_[a] = {lvalue, columns}; }

// Of a function that a batch evaluates.
std::string GraphPrinter::result(const Node *n) {
  const BatchPlace *p = schedule_.place(n);
  const auto &names = results_.at(p->batch);
  const std::string &name = p->batch->function == "sincos" && n->text == "cos" ? names.second : names.first;
  return p->batch->loop || p->batch->args.size() > 1 ? name + "[" + index(p->index) + "]" : name;
}

GraphPrinter::Shown GraphPrinter::combine(const std::string &op, const Node *a, const Node *b, bool integers) {
  Shown x = show(a), y = show(b);
  x.text = binaryText(op, integers ? x.text : real(a), integers ? y.text : real(b));
  x.carried.insert(y.carried.begin(), y.carried.end());
  return x;
}

// a - b for a + -1*b, a - 2*b for a + -2*b.
GraphPrinter::Shown GraphPrinter::sum(const Node *n) {
  const Node *a = n->args[0], *b = n->args[1];
  auto minus = [&](const Node *x) { return isNegative(x) && show(x).text.s[0] == '-'; };
  if (minus(a) && !minus(b)) std::swap(a, b);
  if (!minus(b)) return combine("+", a, b);
  Shown x = show(a), y = show(b);
  Text rest{y.text.s.substr(y.text.s[1] == ' ' ? 2 : 1), b->isNumber() ? Primary : y.text.precedence == Prefix ? Prefix : Product};
  x.text = binaryText("-", real(a), rest);
  x.carried.insert(y.carried.begin(), y.carried.end());
  return x;
}

// -x for -1*x, a/b for a * 1/b.
GraphPrinter::Shown GraphPrinter::product(const Node *n) {
  const Node *a = n->args[0], *b = n->args[1];
  if (a->is(-1)) {
    Shown x = show(b);
    Text t = real(b);
    x.text = t.precedence == Product && t.s[0] != '-' ? Text{"-" + t.s, Product} : unaryText("-", t);
    return x;
  }
  auto inverse = [&](const Node *x) { return x->op == Node::Recip && show(x).text.precedence != Primary; };
  if (inverse(a)) std::swap(a, b);
  if (inverse(b)) {
    Shown x = show(a), y = show(b->args[0]);
    x.text = binaryText("/", real(a), real(b->args[0]));
    x.carried.insert(y.carried.begin(), y.carried.end());
    return x;
  }
  Shown x = combine("*", a, b);
  bool bare =
      a->isNumber() && show(b).text.precedence == Product && show(b).text.s[0] != '-' && show(b).text.s.find('/') == std::string::npos;
  if (bare) x.text = {numberText(a->value) + " * " + show(b).text.s, Product};
  return x;
}

// A function of math.h, of taylor/power.h or of the user.
GraphPrinter::Shown GraphPrinter::call(const Node *n) {
  const bool lanes = inLanes(n);
  Shown s;
  for (size_t i = 0; i < n->args.size(); ++i) {
    const Node *arg = n->args[i];
    Shown x = show(arg);
    std::string text = lanes ? filled(arg).s : real(arg).s;
    if (takesInt(n->text, i)) text = (arg->isConstant() ? "" : "(int)") + operand(x.text, Prefix);
    s.text.s += (s.text.s.empty() ? "" : ", ") + text;
    s.carried.insert(x.carried.begin(), x.carried.end());
  }
  std::string name = n->text;
  if (lanes) name = "tl_lanes_" + (name == "ldexp" ? "scalbn" : name.rfind("tl_", 0) == 0 ? name.substr(3) : name);
  s.text = {name + "(" + s.text.s + ")", Postfix};
  return s;
}

// && and || of C, & and | of lanes.
GraphPrinter::Shown GraphPrinter::logical(const Node *n) {
  const bool both = n->op == Node::Conjunction;
  if (!inLanes(n)) return combine(both ? "&&" : "||", n->args[0], n->args[1], true);
  Shown x = show(n->args[0]), y = show(n->args[1]);
  auto mask = [&](const Node *arg, const Text &text) { return inLanes(arg) ? text : Text{"tl_lanes_truth(" + text.s + ")", Postfix}; };
  x.text = binaryText(both ? "&" : "|", mask(n->args[0], x.text), mask(n->args[1], y.text));
  x.carried.insert(y.carried.begin(), y.carried.end());
  return x;
}

GraphPrinter::Shown GraphPrinter::choice(const Node *n) {
  Shown c = show(n->args[0]), a = show(n->args[1]), b = show(n->args[2]);
  const bool whole = isInteger(n->args[1]) && isInteger(n->args[2]), lanes = inLanes(n);
  auto operandOf = [&](size_t k, const Shown &x) { return whole ? x.text : lanes ? filled(n->args[k]) : real(n->args[k]); };
  const Text x = operandOf(1, a), y = operandOf(2, b);
  if (inLanes(n->args[0]))
    c.text = {"tl_lanes_select(" + c.text.s + ", " + x.s + ", " + y.s + ")", Postfix};
  else
    c.text = {operand(c.text, Or) + " ? " + operand(x, Or) + " : " + operand(y, Choice), Choice};
  c.carried.insert(a.carried.begin(), a.carried.end());
  c.carried.insert(b.carried.begin(), b.carried.end());
  return c;
}

GraphPrinter::Shown GraphPrinter::compute(const Node *n) {
  inLanes(n);
  switch (n->op) {
  case Node::Number:
    return {{numberText(n->value), n->value < 0 ? Prefix : Primary}, {}};
  case Node::Affine:
    return {affine(n), {}};
  case Node::Leaf:
    if (n->slot->integer) return {{"(long)" + leaf(n), Prefix}, {}};
    return {{leaf(n), Postfix}, {}};
  case Node::Carried:
    return {{carriedNames_.at({n->of, size_t(n->which)}), Primary}, {n}};
  case Node::Final:
    return {{carriedNames_.at({n->of, size_t(n->which)}), Primary}, {}};
  case Node::Read:
    return {{element(n->array, n->args[0]), Postfix}, show(n->args[0]).carried};
  case Node::Add:
    return sum(n);
  case Node::Mul:
    return product(n);
  case Node::Recip: {
    Shown x = show(n->args[0]);
    x.text = binaryText("/", {"1.0", Primary}, real(n->args[0]));
    return x;
  }
  case Node::Math:
    return schedule_.place(n) ? Shown{{result(n), Postfix}, {}} : call(n);
  case Node::Taylor:
    return n->args.size() > 1 ? call(n) : Shown{derivativeOf(n), {}};
  case Node::Convert: {
    Shown x = show(n->args[0]);
    x.text = {"(" + n->text + ")" + operand(x.text, Prefix), Prefix};
    return x;
  }
  case Node::Integer:
    return combine(n->text, n->args[0], n->args[1], true);
  case Node::Compare: {
    const Node *a = n->args[0], *b = n->args[1];
    bool constant = a->isNumber() || a->isConstant(), integers = isInteger(a) && isInteger(b);
    if (constant) std::swap(a, b); // x > 0, not 0 < x
    return combine(constant && n->text[0] == '<' ? ">" + n->text.substr(1) : n->text, a, b, integers);
  }
  case Node::Not: {
    Shown x = show(n->args[0]);
    x.text = inLanes(n) ? Text{"tl_lanes_not(" + x.text.s + ")", Postfix} : unaryText("!", x.text);
    return x;
  }
  case Node::Conjunction:
  case Node::Disjunction:
    return logical(n);
  case Node::Select:
    return choice(n);
  }
  std::abort();
}

std::string GraphPrinter::loopText(Loop *loop, int indent) {
  std::string s;
  for (size_t k = 0; k < loop->carried.size(); ++k) {
    if (!schedule_.carries(loop, k)) continue;
    const Carry &c = loop->carried[k];
    std::string name = carriedNames_[{loop, k}] = c.in->name.empty() ? fresh("c" + std::to_string(++carried_)) : fresh(c.in->name);
    std::string init = isInteger(c.init) ? show(c.init).text.s : filled(c.init).s;
    s += blanks(indent) + (isInteger(c.init) ? "long" : number()) + " " + name + " = " + init + ";\n";
    shown_.erase(c.in);
  }
  static const char *const names[] = {"i", "j", "l"};
  if ((loop->trips && inLanes(loop->trips)) || (loop->condition && inLanes(loop->condition)))
    throw Unsuitable{"the number of a loop's iterations depends on the state, which is another in each lane", loop->index->loc};
  int depth = 0;
  for (const Loop *l = loop->outer; l; l = l->outer) ++depth;
  std::string wish = depth < 3 ? names[depth] : "i", name = wish;
  for (int n = 2; taken_.count(name); ++n) name = wish + std::to_string(n);
  indexNames_[loop] = name;
  std::string start, head;
  if (loop->down)
    head = "long " + name + " = " + binaryText("-", show(loop->trips).text, {"1", Primary}).s + "; " + name + " >= 0; --" + name;
  else if (loop->trips)
    head = "long " + name + " = 0; " + binaryText("<", {name, Primary}, show(loop->trips).text).s + "; ++" + name;
  else
    head = "long " + name + " = 0;; ++" + name;
  if (loop->down && loop->trips->isConstant())
    head = "long " + name + " = " + std::to_string(loop->trips->offset - 1) + "; " + name + " >= 0; --" + name;
  taken_.insert(name);
  Loc outside = quoted_;
  quoted_ = {};
  std::string body = block(loop, indent + 2);
  body += updates(loop, indent + 2);
  quoted_ = outside;
  taken_.erase(name);
  for (auto it = externals_.begin(); it != externals_.end();) {
    const Loop *in = it->first.second->loop;
    it = in && in->within(loop) ? externals_.erase(it) : std::next(it);
  }
  std::string unread = loop->trips ? "" : blanks(indent + 2) + "(void)" + name + ";\n"; // a body need not look at it
  return s + blanks(indent) + "for (" + head + ") {\n" + unread + body + blanks(indent) + "}\n";
}

// x += y for x = x + y; x -= y for a product -y, not for a sum that begins like one.
std::string GraphPrinter::update(const Carry &carry, const std::string &name, const Shown &to) {
  const Node *out = carry.out, *in = carry.in;
  if (isInteger(carry.init)) {
    if (inLanes(out)) throw Unsuitable{"an integer depends on the state, which is another in each lane", out->loc};
    return name + " = " + to.text.s;
  }
  bool grows = out->op == Node::Add && to.text.precedence != Primary && (out->args[0] == in || out->args[1] == in);
  if (!grows) return name + " = " + (to.text.precedence == Primary && !lanes_ ? to.text : filled(out)).s;
  const Node *other = out->args[out->args[0] == in ? 1 : 0];
  Text more = real(other);
  bool negative = more.s[0] == '-' && more.precedence >= Product;
  return negative ? name + " -= " + more.s.substr(more.s[1] == ' ' ? 2 : 1) : name + " += " + more.s;
}

// Carried values become what they are at the end of the iteration, all at once: one that another's new value is computed from is
// updated after that.
std::string GraphPrinter::updates(const Loop *loop, int indent) {
  struct Update {
    const Carry *carry;
    std::string name;
    Shown to;
  };
  std::vector<Update> open;
  for (size_t k = 0; k < loop->carried.size(); ++k) {
    const Carry &c = loop->carried[k];
    if (schedule_.carries(loop, k) && c.out != c.in) open.push_back({&c, carriedNames_.at({loop, k}), show(c.out)});
  }
  std::string s;
  while (!open.empty()) {
    auto free = std::find_if(open.begin(), open.end(), [&](const Update &u) {
      return std::none_of(open.begin(), open.end(), [&](const Update &o) { return &o != &u && o.to.carried.count(u.carry->in); });
    });
    if (free == open.end()) { // a circle
      Update &u = open.front();
      std::string name = fresh("next");
      s += blanks(indent) + "const " + (isInteger(u.carry->init) ? "long" : number()) + " " + name + " = " + u.to.text.s + ";\n";
      u.to = {{name, Primary}, {}};
      continue;
    }
    s += blanks(indent) + update(*free->carry, free->name, free->to) + ";\n";
    open.erase(free);
  }
  return s;
}

std::string GraphPrinter::batch(const Batch &b, int indent) {
  const std::string start = blanks(indent), sincos = lanes_ ? "tl_sincos_lanes" : "tl_sincos_array";
  std::string s;
  if (!b.loop && b.args.size() == 1) {
    std::string sine = fresh("sine"), cosine = fresh("cosine"), angle = fresh("angle");
    results_[&b] = {sine, cosine};
    s = start + "const " + number() + " " + angle + " = " + filled(b.args[0]).s + ";\n";
    return s + start + number() + " " + sine + ", " + cosine + ";\n" + start + sincos + "(1, &" + angle + ", &" + sine + ", &" +
           cosine + ");\n";
  }
  long count = b.loop ? b.loop->trips->offset : long(b.args.size());
  std::string size = "[" + std::to_string(count) + "]", from;
  if (b.first) {
    from = "&" + leaf(b.first);
    if (b.first->args[0]->offset == 0) from = b.first->slot->kind == Slot::Q ? "q" : "qd";
  } else if (b.filled) {
    from = arrayName(b.filled);
  } else {
    from = fresh(b.function == "sincos" ? "angles" : "arguments");
    std::string list;
    for (const Node *arg : b.args) list += (list.empty() ? "" : ", ") + filled(arg).s;
    s += start + "const " + number() + " " + from + size + " = {" + list + "};\n";
  }
  if (b.function == "sincos") {
    std::string sines = fresh("sines"), cosines = fresh("cosines");
    results_[&b] = {sines, cosines};
    return s + start + number() + " " + sines + size + ", " + cosines + size + ";\n" + start + sincos + "(" + std::to_string(count) +
           ", " + from + ", " + sines + ", " + cosines + ");\n";
  }
  std::string values = fresh(b.function + "s");
  results_[&b] = {values, ""};
  return s + start + number() + " " + values + size + ";\n" + start + "for (int i = 0; i < " + std::to_string(count) + "; ++i) " +
         values + "[i] = " + (lanes_ ? "tl_lanes_" : "") + b.function + "(" + (from[0] == '&' ? "(" + from + ")" : from) + "[i]);\n";
}

std::string GraphPrinter::check(const Check &c, int indent) {
  size_t site = sites_.number(c.node);
  failing_.insert(site);
  Text fails = show(c.outside).text;
  const bool lanes = inLanes(c.outside);
  if (lanes && c.guard && inLanes(c.guard->holds))
    fails = {"tl_lanes_any(" + binaryText("&", show(c.guard->holds).text, fails).s + ")", Postfix};
  else if (lanes)
    fails = {"tl_lanes_any(" + fails.s + ")", Postfix};
  if (c.guard && !(lanes && inLanes(c.guard->holds))) {
    Text holds = show(c.guard->holds).text;
    if (inLanes(c.guard->holds)) holds = {"tl_lanes_any(" + holds.s + ")", Postfix};
    fails = binaryText("&&", holds, fails);
  }
  return blanks(indent) + "outside" + std::to_string(site) + " |= " + fails.s + ";\n";
}

std::string GraphPrinter::clear(const Array *a, int indent) {
  auto known = bound_.find(a);
  std::string lvalue = known == bound_.end() ? arrayName(a) + "[%]" : known->second.lvalue;
  bool matrix = std::count(lvalue.begin(), lvalue.end(), '%') == 2;
  auto loop = [](const std::string &i, long count) {
    return "for (int " + i + " = 0; " + i + " < " + std::to_string(count) + "; ++" + i + ") ";
  };
  long columns = matrix ? known->second.columns : 1;
  return blanks(indent) + loop("i", a->length / columns) + (matrix ? loop("j", columns) : "") +
         fill(lvalue, {{"i", Primary}, {"j", Primary}}) + (lanes_ ? " = tl_lanes_of(0.0);\n" : " = 0.0;\n");
}

// Taylor coefficients of an external function of one argument, by the user's rule, as far as any of its derivatives is needed.
std::string GraphPrinter::external(const Node *n, int indent) {
  auto key = std::make_pair(n->text, (const Node *)n->args[0]);
  if (n->args.size() > 1 || externals_.count(key)) return "";
  std::string name = externals_[key] = fresh(n->text + "_coefs"), order = std::to_string(schedule_.highest(n));
  size_t site = sites_.number(n);
  failing_.insert(site);
  return blanks(indent) + "tl_real " + name + "[" + order + " + 1];\n" + blanks(indent) + "outside" + std::to_string(site) +
         " |= " + program_.rules.at(n->text).taylor + "(" + name + ", " + real(n->args[0]).s + ", " + order + ", NULL) != TL_OK;\n";
}

Text GraphPrinter::derivativeOf(const Node *n) {
  Text coefficient{externals_.at({n->text, n->args[0]}) + "[" + std::to_string(n->which) + "]", Postfix};
  double factorial = 1;
  for (int k = 2; k <= n->which; ++k) factorial *= k;
  return factorial == 1 ? coefficient : binaryText("*", {numberText(factorial), Primary}, coefficient);
}

} // namespace tlgen
