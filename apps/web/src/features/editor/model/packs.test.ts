import { definitions, stacksOf, type Block } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { describe, expect, it } from 'vitest'
import { loadFor } from './packs.ts'

const plain = Object.entries({ ...definitions, ...learning }).map(
  ([type, { example }]) => [type, example] as const,
)

describe('the example of a plain block', () => {
  it.each(plain)('%s is drawn without the whole language', async (_type, example) => {
    const stacks = stacksOf(example).map((blocks) => ({ x: 0, y: 0, blocks: blocks as readonly Block[] }))
    const program = { stacks, config: { stacks: [] } }
    expect(await loadFor({ programs: { program }, brains: {} })).toBe(false)
  })
})
