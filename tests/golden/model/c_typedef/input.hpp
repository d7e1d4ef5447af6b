#pragma once
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif
typedef struct { uint64_t time; float padding[32]; } Frame;
typedef enum { FRAME_RAW, FRAME_DONE } FrameState;
struct Pair { Frame first; FrameState state; };
#ifdef __cplusplus
}
#endif
