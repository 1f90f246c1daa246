/* Status texts. */
#include "eom/status.h"

const char *eom_status_text(eom_status status) {
  static const char *const text[] = {
#define EOM_X(name, sentence) sentence,
      EOM_STATUSES(EOM_X)
#undef EOM_X
  };
  return (size_t)status < sizeof text / sizeof text[0] ? text[status] : "unknown status";
}
