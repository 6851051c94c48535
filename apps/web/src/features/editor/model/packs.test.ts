import { definitions, isBlockType, stacksOf, type Block } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
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

describe('the blocks for deeper networks', () => {
  type Need = Parameters<typeof loadFor>[0]
  type Layer = Need['brains'][string]['layers'][number]
  /** Whether a page without them has them after it has loaded the blocks for this. */
  async function areLoadedFor(need: Need): Promise<boolean> {
    for (const type of Object.keys(learning)) Reflect.deleteProperty(definitions, type)
    await loadFor(need)
    return isBlockType('ai_nn_hidden_layer')
  }
  const { card, world } = content.card('friendship')!
  const friendship = cardProject(world, card, content.program('friendship', 'solution')!, 'friendship')
  const [[id, brain]] = Object.entries(friendship.brains) as [[string, Need['brains'][string]]]

  it('are not loaded for a network of one layer', async () => {
    expect(await areLoadedFor(friendship)).toBe(false)
  })

  it('are loaded where one block of many needs them', async () => {
    const layer: Block = { id: 'layer', type: 'ai_nn_hidden_layer' }
    const more = { stacks: [{ x: 0, y: 0, blocks: [layer] }], config: { stacks: [] } }
    expect(await areLoadedFor({ brains: {}, programs: { ...friendship.programs, more } })).toBe(true)
  })

  it('are loaded where one neuron of many does more than hand on its sum', async () => {
    const [inputs, [first, ...others]] = brain.layers as [Layer, [Layer[number], ...Layer]]
    const layers = [inputs, [{ ...first, activation: 'relu' as const }, ...others]]
    expect(await areLoadedFor({ programs: {}, brains: { [id]: { ...brain, layers } } })).toBe(true)
  })
})
