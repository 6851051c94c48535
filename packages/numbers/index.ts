export { sin, cos } from './sin-cos.ts'
export { atan2 } from './atan2.ts'
export { draw, fastDraw, fastStream, stream, type FastStream, type StreamState } from './random.ts'
export { addToHash, hex, startHash, type Hash } from './hash.ts'
