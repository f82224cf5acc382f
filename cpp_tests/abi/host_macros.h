/* Words that programs define as macros before they include a library's header: Unreal's check and verify,
 * Windows's min, max, near, far, small and interface, X11's None and Status, and others. Wherever a header of
 * ours uses one of them, this does not compile. Standard headers come first, as hosts include them first. */
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>
#endif

#define HOST_MACRO @ a macro of the host @
/* As functions, as hosts define them. */
#define check(...) HOST_MACRO
#define checkf(...) HOST_MACRO
#define ensure(...) HOST_MACRO
#define verify(...) HOST_MACRO
#define assert(...) HOST_MACRO
#define expect(...) HOST_MACRO
#define require(...) HOST_MACRO
#define min(...) HOST_MACRO
#define max(...) HOST_MACRO
#define abs(...) HOST_MACRO
#define swap(...) HOST_MACRO
#define major(...) HOST_MACRO
#define minor(...) HOST_MACRO
/* As words. */
#define near HOST_MACRO
#define far HOST_MACRO
#define small HOST_MACRO
#define huge HOST_MACRO
#define pascal HOST_MACRO
#define interface HOST_MACRO
#define IN HOST_MACRO
#define OUT HOST_MACRO
#define OPTIONAL HOST_MACRO
#define CONST HOST_MACRO
#define ERROR HOST_MACRO
#define OPAQUE HOST_MACRO
#define TRANSPARENT HOST_MACRO
#define DELETE HOST_MACRO
#define PI HOST_MACRO
#define None HOST_MACRO
#define Always HOST_MACRO
#define Bool HOST_MACRO
#define True HOST_MACRO
#define False HOST_MACRO
#define Status HOST_MACRO
#define Success HOST_MACRO
#define Complex HOST_MACRO
#define I HOST_MACRO
#define linux HOST_MACRO
#define unix HOST_MACRO
