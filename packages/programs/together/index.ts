// Two edit one program: operations as data, one common order, and what each end does while it has not heard of all of it.
export { diff } from './diff.ts'
export { Peer } from './peer.ts'
export { resumed } from './resume.ts'
export { mostAtOnce, sendingSchema } from './schema.ts'
export type { Back } from './undo.ts'
export type * from './types.ts'
