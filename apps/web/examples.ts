import type { Plugin } from 'vite'
import { asData } from './data.ts'

/** A block's example stands last in its definition, or in what makes some. */
const example = /\n {2}example: (?:[^\n]*|\[\n[^]*?\n {2}\]),(?=\n\}\)?)/g

/** Only who asks for an example fetches one: definitions are built without them. */
const noExamples: Plugin = {
  name: 'no-examples',
  apply: 'build',
  enforce: 'pre',
  transform: {
    filter: { id: /packages[\\/]blocks[\\/].*\.ts$/ },
    handler: (code) => ({ code: code.replace(example, ''), map: null }),
  },
}

const id = 'content:examples'

/** `content:examples`: brings every block's example, by its type. */
const allExamples: Plugin = {
  name: 'all-examples',
  resolveId: { filter: { id: /^content:examples$/ }, handler: () => `\0${id}` },
  load: {
    filter: { id: /^\0content:examples$/ },
    async handler() {
      const { definitions } = await import('../../packages/blocks/index.ts')
      const { expert } = await import('../../packages/blocks/packs/expert/index.ts')
      const all = Object.entries({ ...definitions, ...expert })
      return asData(
        this,
        'examples.json',
        Object.fromEntries(all.map(([type, { example }]) => [type, example])),
      )
    },
  },
}

export const examples: readonly Plugin[] = [noExamples, allExamples]
