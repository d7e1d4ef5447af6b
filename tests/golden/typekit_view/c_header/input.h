/* Cases 54 and 87 of the type matrix: a header for C. */
#ifndef C_HEADER_INPUT_H
#define C_HEADER_INPUT_H
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif
typedef struct {
    uint64_t time;
    float padding[4];
} c_frame;
typedef enum { C_FRAME_RAW, C_FRAME_DONE } c_state;
struct c_pair {
    c_frame first;
    c_state state;
    enum { C_LEFT, C_RIGHT } side;
};
#ifdef __cplusplus
}
#endif
#endif
