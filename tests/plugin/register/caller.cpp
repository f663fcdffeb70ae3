#include "answer.h"

extern "C" DDT_TEST_EXPORT int call_answer() {
    return answer();
}
