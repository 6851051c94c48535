import { readFileSync } from 'node:fs'
import type { Project } from '@botgarten/programs'
import { Blocks } from './runs/blocks.ts'

const cards = {
  friendship: { name: 'Friendship', folder: '05-friendship' },
  fear: { name: 'Fear', folder: '06-fear' },
}

const read = (path: string) =>
  JSON.parse(readFileSync(new URL(`../content/${path}`, import.meta.url), 'utf8')) as object

/** The text of a project file, as a child would have saved it from a card. */
export function projectFile(card: keyof typeof cards, program: string): string {
  const project = {
    ...{ botgarten: 1, name: cards[card].name, card, assets: {} },
    ...read(`cards/network/${cards[card].folder}/${program}.json`),
    world: read(`worlds/${card}/world.json`),
  }
  return JSON.stringify(project)
}

/** The text of a project file from the free lab, with what its `main` program does. */
function freeProject(name: string, { programs, brains }: Pick<Project, 'programs' | 'brains'>): string {
  const world = read('worlds/garden/world.json')
  return JSON.stringify({ botgarten: 1, name, programs, brains, world, assets: {} })
}

type Block = ReturnType<Blocks['block']>

/** A free project of one stack of blocks that has no network. */
export function freeProgram(name: string, stack: (make: Blocks) => readonly Block[]): string {
  const make = new Blocks()
  return freeProject(name, { programs: { main: make.program(...stack(make)) }, brains: {} })
}

/** A loop with a stack of its own beside it: a net of two eyes and two wheels that nothing starts. */
export function looseNet(name: string): string {
  const make = new Blocks()
  const { block, brain } = make.net(
    [make.eye('2'), make.eye('3')],
    [make.wheel('C'), make.wheel('B')],
    [[0.5]],
  )
  const { stacks, ...program } = make.program(make.forever())
  const main = { ...program, stacks: [...stacks, { x: 60, y: 220, blocks: [block] }] }
  return freeProject(name, { programs: { main }, brains: { [block.id]: brain } })
}

/** A net as big as a child may build one: eight sensor neurons, six outputs, all weights 0. */
export function bigNet(name: string): string {
  const make = new Blocks()
  const colours = ['#000000', '#0057A6', '#00642E', '#F7D117', '#B30006']
  const colour = (COLOUR: string) =>
    make.block('ai_nn_input_node_coloursensor_color', { fields: { COLOUR, SENSORPORT: '1' } })
  const inputs = [make.eye('2'), make.eye('3'), make.brightness(), ...colours.map(colour)]
  const lamp = make.block('ai_nn_output_node_led', { fields: { OUTPUTNODE: '#00642E' } })
  const word = make.block('ai_nn_output_node_text', { fields: { OUTPUTNODE: 'Hallo' } })
  const motor = (port: string) =>
    make.block('ai_nn_output_node', { fields: { OUTPUTNODE: `MOTORPORT_${port}` } })
  const outputs = [make.wheel('C'), make.wheel('B'), motor('A'), motor('D'), lamp, word]
  const { block, brain } = make.net(inputs, outputs, [])
  return freeProject(name, {
    programs: { main: make.program(make.forever(block)) },
    brains: { [block.id]: brain },
  })
}

/** A net with a hidden layer, and these distance sensors before it. */
export function emptyNet(name: string, neurons: string, eyes: readonly string[]): string {
  const make = new Blocks()
  const { block } = make.net(
    eyes.map((port) => make.eye(port)),
    [make.wheel('C')],
    [],
  )
  const { INPUT_LAYER: before, ...others } = block.values!
  const hidden = make.block('ai_nn_hidden_layer', {
    fields: { NEURONS: neurons, ACTIVATION: 'RELU' },
    values: { LAYER: before! },
  })
  const net = { ...block, values: { INPUT_LAYER: hidden, ...others } }
  return freeProject(name, { programs: { main: make.program(make.forever(net)) }, brains: {} })
}

/** A net of 200 neurons: 20 sensors, eight hidden layers of 20, 20 words. */
export function deepNet(name: string): string {
  const make = new Blocks()
  const twenty = <Thing>(one: (k: number) => Thing) => Array.from({ length: 20 }, (_, k) => one(k))
  const words = twenty((k) => make.block('ai_nn_output_node_text', { fields: { OUTPUTNODE: `word ${k}` } }))
  const { block } = make.net(
    twenty((k) => make.eye(k % 2 === 0 ? '2' : '3')),
    words,
    [],
  )
  const { INPUT_LAYER: list, ...others } = block.values!
  const layer = (before: typeof block) =>
    make.block('ai_nn_hidden_layer', {
      fields: { NEURONS: '20', ACTIVATION: 'TANH' },
      values: { LAYER: before },
    })
  const inputs = Array.from({ length: 8 }).reduce<typeof block>(layer, list!)
  const net = { ...block, values: { INPUT_LAYER: inputs, ...others } }
  return freeProject(name, { programs: { main: make.program(make.forever(net)) }, brains: {} })
}

/** A net of one distance sensor and one word neuron, weight 0. */
export function wordNet(name: string, word: string): string {
  const make = new Blocks()
  const shown = make.block('ai_nn_output_node_text', { fields: { OUTPUTNODE: word } })
  const { block, brain } = make.net([make.eye('2')], [shown], [])
  return freeProject(name, {
    programs: { main: make.program(make.forever(block)) },
    brains: { [block.id]: brain },
  })
}

/** Bo has a bumper, a turning sensor and a sound sensor, turns on the spot, and says what it hears. */
export function sayingProject(name: string): string {
  const text = freeProgram(name, (make) => {
    const sense = (kind: string, MODE: string, SENSORPORT: string) =>
      make.block(`robSensors_${kind}_getSample`, { fields: { MODE, SENSORPORT } })
    const shows = (value: Block, row: number) =>
      make.block('robActions_display_text', {
        values: { OUT: value, COL: make.number(0), ROW: make.number(row) },
      })
    const says = (value: Block) => make.block('robActions_sayText', { values: { OUT: value } })
    const hello = make.block('text', { fields: { TEXT: 'Hallo!' } })
    return [
      make.turnRight(30, 90),
      make.forever(
        ...[sense('gyro', 'ANGLE', '2'), sense('touch', 'PRESSED', '1'), sense('sound', 'SOUND', '3')].map(
          shows,
        ),
        says(hello),
      ),
    ]
  })
  const { world, ...project } = JSON.parse(text) as Project
  const [bo] = world.robots
  const sensors = {
    '1': { kind: 'touch', x: 10, y: 0, angle: 0 },
    '2': { kind: 'gyro', x: 0, y: 0, angle: 0 },
    '3': { kind: 'sound', x: 0, y: 5, angle: 0 },
  } as const
  const robots = [{ ...bo!, config: { ...bo!.config, sensors } }]
  return JSON.stringify({ ...project, world: { ...world, robots } })
}

/** x is 7, then 12; then Bo waits. `b6` waits first, `b10` last. */
export function countingProject(name: string): string {
  const text = freeProgram(name, (make) => {
    const set = make.block('variables_set', {
      fields: { VAR: 'x' },
      mutation: { attrs: { datatype: 'Number' } },
      values: { VALUE: make.number(12) },
    })
    return [make.wait(100), set, make.wait(200)]
  })
  const project = JSON.parse(text) as Project
  const start = project.programs['main']!.stacks[0]!.blocks[0]!
  const declared = {
    ...{ id: 'x', type: 'robGlobalVariables_declare', fields: { TYPE: 'Number', VAR: 'x' } },
    mutation: { attrs: { next: 'false', declaration_type: 'Number' } },
    values: { VALUE: { id: 'seven', type: 'math_number', fields: { NUM: '7' } } },
  }
  Object.assign(start, { mutation: { attrs: { declare: 'true' } }, statements: { ST: [declared] } })
  return JSON.stringify(project)
}
