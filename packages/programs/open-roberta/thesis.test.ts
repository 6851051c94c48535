import { readFileSync, readdirSync } from 'node:fs'
import { addBlocks, definitions, isBlockType, knowMaps, type Block } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { describe, expect, it } from 'vitest'
import { check, indexProgram, networks, runThread, startThread } from '../index.ts'
import { nextTick, recordingRobot } from '../testing/recording-robot.ts'
import { xmlTree } from '../testing/xml-tree.ts'
import { robotIn } from './brick.ts'
import { readOpenRoberta, writeOpenRoberta } from './index.ts'

addBlocks(learning)
// The three maps of the thesis; content holds them.
knowMaps({ maps: ['railway', 'forest', 'city'], stations: { railway: 6, forest: 10, city: 20 } })

const folder = new URL('../testing/open-roberta/thesis/', import.meta.url)
const textOf = (name: string) => readFileSync(new URL(`${name}.xml`, folder), 'utf8')
const files = readdirSync(folder).map((file) => file.slice(0, -'.xml'.length))

const blocksIn = (block: Block): Block[] => [
  block,
  ...[...Object.values(block.values ?? {}), ...Object.values(block.statements ?? {}).flat()].flatMap(
    blocksIn,
  ),
]

describe.each(files)('%s', (name) => {
  const program = readOpenRoberta(textOf(name))
  const blocks = program.stacks.flatMap((stack) => stack.blocks.flatMap(blocksIn))

  it('comes back as it was', () => {
    expect(xmlTree(writeOpenRoberta(program))).toEqual(xmlTree(textOf(name)))
  })

  it('has blocks that are known, with values that they offer', () => {
    for (const { type, fields = {} } of blocks) {
      expect(isBlockType(type), type).toBe(true)
      if (!isBlockType(type)) continue
      for (const look of definitions[type].look.fields)
        if (look.kind === 'choice' && fields[look.name] !== undefined && !('numbers' in look))
          expect(look.options.map(({ value }) => value.toUpperCase())).toContain(
            fields[look.name]!.toUpperCase(),
          )
    }
  })

  it('has nothing that would have to be mended on the robot of its file, and runs', () => {
    expect(check(program, robotIn(program.config)).filter(({ stops }) => stops)).toEqual([])
    const recording = recordingRobot(3)
    const thread = startThread(indexProgram(program))
    for (let tick = 0; tick < 5; tick++) {
      runThread(thread, indexProgram(program), recording.context)
      nextTick(recording)
    }
    expect(thread.problem).toBeNull()
  })
})

/** What the networks of a file read and drive, as the playground labels it. */
const netsOf = (name: string) =>
  networks(readOpenRoberta(textOf(name))).map(({ inputs, outputs }) => {
    const words = (neurons: typeof inputs) =>
      neurons.map(({ look, fields }) => [look.label, ...Object.values(fields)].join(' '))
    return `${words(inputs).join(', ')} → ${words(outputs).join(', ')}`
  })

it.each([
  ['figure-16', ['neuron.colour #00642e 1 → neuron.lamp #00642E']],
  [
    'chameleon',
    [
      'neuron.colour #00642e 1, neuron.colour #f7d117 1, neuron.colour #b30006 1 → neuron.lamp #00642E, neuron.lamp #F7D118, neuron.lamp #B30006',
    ],
  ],
  ['loud-distance', ['neuron.distance ULTRASONIC_PORT_2 → neuron.sound']],
  [
    'friendship',
    [
      'neuron.distance ULTRASONIC_PORT_2, neuron.distance ULTRASONIC_PORT_3 → neuron.motor MOTORPORT_C, neuron.motor MOTORPORT_B',
    ],
  ],
  [
    'interest',
    [
      'neuron.colour #b30006 1, neuron.colour #0057a6 1, neuron.colour #000000 1 → neuron.text Rot & warm, neuron.text Blau, neuron.text <Schwarz>',
    ],
  ],
  [
    'rally',
    [
      'neuron.channel #FF0000 1, neuron.channel #00FF00 1, neuron.channel #0000FF 1 → neuron.motor MOTORPORT_B, neuron.motor MOTORPORT_C',
    ],
  ],
  ['two-nets', ['neuron.distance ULTRASONIC_PORT_2 → neuron.sound', 'neuron.light 1 → neuron.lamp #B30006']],
  ['incognito', ['neuron.light 1 → neuron.motor MOTORPORT_B, neuron.motor MOTORPORT_C']],
])('%s has the network that is drawn in it', (name, nets) => {
  expect(netsOf(name)).toEqual(nets)
})

it('colours in small letters are the same colours', () => {
  const recording = recordingRobot(3)
  const index = indexProgram(readOpenRoberta(textOf('interest')))
  runThread(startThread(index), index, recording.context)
  expect(recording.log.find(([, verb]) => verb === 'think')?.at(-1)).toEqual([100, 0, 0])
})
