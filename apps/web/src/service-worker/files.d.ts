/** Made by chunks.ts while the pages are built. */
declare module 'virtual:files-of-teachers' {
  /** Addresses below the lab's own, such as `_app/immutable/nodes/22.CXSoBLMq.js`. */
  export const ofTeachers: readonly string[]
}
