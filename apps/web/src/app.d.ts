import type { Merged } from '#storage/files.ts'

declare global {
  /** Is this the build for a web space? */
  const __WEB_SPACE__: boolean

  namespace App {
    interface PageState {
      /** What became of a home file that was opened on the way to this page. */
      merged?: Merged
      /** A file was too much: only what could be opened is here. */
      lost?: boolean
      /** A file was opened on the way to this page. */
      fromFile?: boolean
    }
  }
}
