import type { Merged } from '#lib/storage/files.ts'

declare global {
  namespace App {
    interface PageState {
      /** What became of a home file that was opened on the way to this page. */
      merged?: Merged
    }
  }
}
