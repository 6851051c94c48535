import type { Plugin } from 'vite'

/** A block's example stands last in its definition, or in what makes some. */
const example = /\n {2}example: (?:[^\n]*|\[\n[^]*?\n {2}\]),(?=\n\}\)?)/g

/** Only tests ask a block for its example: what is built goes without them. */
export const noExamples: Plugin = {
  name: 'no-examples',
  apply: 'build',
  enforce: 'pre',
  transform: {
    filter: { id: /packages[\\/]blocks[\\/].*\.ts$/ },
    handler: (code) => ({ code: code.replace(example, ''), map: null }),
  },
}
