// The numbers that a graph of values stands for, computed node by node.
#ifndef TEST_EVALUATOR_H
#define TEST_EVALUATOR_H

#include "Graph.h"

#include <functional>

// A real or integer.
struct Value {
  double real = 0;
  long integer = 0;
  bool isInteger = false;

  double asReal() const { return isInteger ? double(integer) : real; }
  static Value of(double x) { return {x, 0, false}; }
  static Value of(long n) { return {0, n, true}; }
};

class Evaluator {
public:
  using Input = std::function<Value(const tlgen::Slot &slot, const std::vector<long> &indices)>;
  using External = std::function<double(const std::string &function, const std::vector<double> &args)>;

  Evaluator(Input input, External external) : input_(std::move(input)), external_(std::move(external)) {}

  double value(const tlgen::Node *n);
  std::vector<double> rows(const tlgen::Array *array);

private:
  struct Memory {
    std::vector<Value> elements;
    std::vector<bool> written;
    bool filled = false;
  };
  void reach(const tlgen::Node *n);
  void reach(const tlgen::Array *array);
  void reach(const tlgen::Loop *loop);
  Value of(const tlgen::Node *n);
  Value compute(const tlgen::Node *n);
  Value operation(const tlgen::Node *n);
  Value element(const tlgen::Array *array, long index);
  void fill(const tlgen::Array *array);
  void write(const tlgen::Array *array, const tlgen::Write &w);
  void run(const tlgen::Loop *loop);
  void forget(const tlgen::Loop *loop);

  Input input_;
  External external_;
  std::set<const tlgen::Node *> reached_;
  std::set<const tlgen::Array *> arrays_;
  std::set<const tlgen::Loop *> loops_;
  std::unordered_map<const tlgen::Node *, Value> known_;
  std::unordered_map<const tlgen::Loop *, long> iteration_;
  std::unordered_map<const tlgen::Loop *, std::vector<Value>> carried_;
  std::set<const tlgen::Loop *> done_, running_;
  std::unordered_map<const tlgen::Array *, Memory> memory_;
};

#endif
