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
