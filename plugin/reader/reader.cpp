#include <OpenImageIO/imageio.h>

