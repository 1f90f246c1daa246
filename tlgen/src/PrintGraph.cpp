// C from a graph: statements, loops.
#include "PrintGraph.h"
#include "Trace.h"

#include <algorithm>
#include <cstdlib>

namespace tlgen {
namespace {

const size_t longestExpression = 100; // characters; what is longer is taken apart
const long longestLocal = 64;         // numbers of an array on the stack

std::string blanks(int n) { return std::string(size_t(n), ' '); }

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

} // namespace

size_t Sites::number(const Node *node) {
  std::string function = node->op == Node::Taylor ? "compose" : sourceFunction(node);
  if (function == "tl_power") function = "pow";
  for (size_t i = 0; i < sites_.size(); ++i)
    if (sites_[i].function == function && sites_[i].loc.file == node->loc.file && sites_[i].loc.line == node->loc.line) return i + 1;
  sites_.push_back({function, node->loc});
  return sites_.size();
}

GraphPrinter::GraphPrinter(Schedule &schedule, const Program &program, Sites &sites, std::set<std::string> taken, bool lanes)
    : schedule_(schedule), program_(program), sites_(sites), taken_(std::move(taken)), lanes_(lanes) {}

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
  return !schedule_.isUsedOnce(n) || readLength(shown.text.s) > longestExpression;
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
         values + "[i] = " + functionText(b.function, (from[0] == '&' ? "(" + from + ")" : from) + "[i]", lanes_).s + ";\n";
}

std::string GraphPrinter::check(const Check &c, int indent) {
  size_t site = sites_.number(c.node);
  failing_.insert(site);
  Text fails = c.guard ? both("&&", c.guard->holds, c.outside).text : show(c.outside).text;
  if (inLanes(c.outside) || (c.guard && inLanes(c.guard->holds))) fails = {"tl_lanes_any(" + fails.s + ")", Postfix};
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
         fill(lvalue, {{"i", Primary}, {"j", Primary}}) + (lanes_ ? " = TL_LANES_ZERO;\n" : " = TL_C(0.0);\n");
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

} // namespace tlgen
