// tlgen: rewrites plain C Lagrangians as functions on truncated Taylor series.
#include "Generate.h"

int main(int argc, char **argv) {
  tlgen::Options options;
  switch (tlgen::parseOptions(argc, argv, options)) {
  case tlgen::Command::Generate:
    return tlgen::generate(options);
  case tlgen::Command::Done:
    return 0;
  case tlgen::Command::Fail:
    break;
  }
  return 2;
}
