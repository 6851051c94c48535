import { parts } from '@botgarten/blocks/configuration'
import { expect, it } from 'vitest'
import { unknownPorts } from './plugs.ts'

const plugged = (...types: readonly string[]) => ({
  stacks: [
    {
      ...{ x: 0, y: 0 },
      blocks: [
        {
          ...{ id: 'brick', type: 'robBrick_EV3-Brick' },
          values: Object.fromEntries(types.map((type, k) => [`S${k + 1}`, { id: type, type }])),
        },
      ],
    },
  ],
})

it('what the picture and the lists of ports show is not said twice', () => {
  expect(unknownPorts(plugged(...parts.map(({ type }) => type)))).toEqual([])
  expect(unknownPorts({ stacks: [] })).toEqual([])
})

it('what nobody knows is said with its port', () => {
  expect(unknownPorts(plugged('robBrick_touch', 'robBrick_nose'))).toEqual(['2'])
})
