import type { CardProgram } from '@botgarten/content'
import type { Brain } from '@botgarten/learning/neural-network'
import { headOfRow, place, type Row } from '@botgarten/learning/neural-network/examples'
import { expect } from '@playwright/test'
import { BlockHands } from './child-blocks.ts'
import { NetHands } from './child-network.ts'
import { TimeHands } from './child-time.ts'
import { Teaching } from './child-training.ts'
import type { Child } from './child.ts'

interface Task {
  readonly start: CardProgram
  readonly solution: CardProgram
}

const brainIn = ({ brains }: CardProgram): Brain => Object.values(brains)[0]!

/** Is a card solved by practice and not by knobs that a hand turns? */
export const isPractised = ({ solution }: Task): boolean =>
  (Object.values(solution.brains)[0]?.practice?.round ?? 0) > 0

/** Solves a card as its hints say: layers are put in, places shown, wrong rows set aside, and all of it is practised. */
export async function practises(child: Child, { start, solution }: Task) {
  const [before, after] = [brainIn(start), brainIn(solution)]
  const teaching = new Teaching(child)
  await putsLayersIn(child, before, after)
  if (seesLight(after) && !seesLight(before)) await addsLight(child)
  const [shown, aside] = [rowsToShow(before, after), rowsToSetAside(after)]
  if (shown.length > 0 || aside.length > 0) await teaching.shows()
  if (shown.length > 0) await (isDriven(after) ? drives(child, after) : showsRows(child, shown, after))
  for (const row of aside) await teaching.setsAside(row)
  if (isCoached(after)) await coaches(child)
  await teaching.letsPractise()
  if (isMirrored(before) !== isMirrored(after)) await teaching.switchesMirror()
  await teaching.setsUp(changed(before, after))
  await teaching.practises()
  // Bo stands where the last example was shown: only a start place counts.
  if (shown.length > 0 || isCoached(after)) await child.presses('lab.place', { number: 1 })
}

/** What the solution sets otherwise of how fast and how long it practises. */
function changed(before: Brain, after: Brain): { readonly rate?: number; readonly rounds?: number } {
  const [given, { rate, rounds }] = [before.practice!.settings, after.practice!.settings]
  return { ...(rate !== given.rate && { rate }), ...(rounds !== given.rounds && { rounds }) }
}

/** Every hidden layer that the solution has more, with its neurons and what they do with their sums. */
async function putsLayersIn(child: Child, before: Brain, after: Brain) {
  const hands = new NetHands(child)
  const layers = after.layers.slice(1, after.layers.length - before.layers.length + 1)
  if (layers.length === 0) return
  await child.presses('network.byHand')
  await hands.chooses('expert')
  for (const [index, neurons] of layers.entries()) {
    const layer = index + 1
    await child.presses('net.addLayer')
    const nodes = (await hands.layer(layer).locator('b').textContent()) ?? ''
    const missing = neurons.length - Number(nodes)
    for (let presses = Math.abs(missing); presses > 0; presses -= 1)
      await child.presses(missing > 0 ? 'net.more' : 'net.fewer', { layer })
    await child.press(hands.neuron(layer, 1))
    const name = child.word('net.hidden', { layer, neuron: 1 })
    const choice = child.page.getByRole('combobox', { name: child.word('net.activationOf', { name }) })
    await choice.selectOption(neurons[0]!.activation)
    await expect(hands.layer(layer)).toContainText(child.word(`net.activation.${neurons[0]!.activation}`))
  }
}

const seesLight = ({ layers }: Brain) => layers[0]!.some(({ id }) => id === 'light')

/** Pulls the block that reads how bright the floor is to the end of the sensors' list. */
async function addsLight(child: Child) {
  const hands = new BlockHands(child)
  const name = child.word('block.ai_nn_input_node_coloursensor_light.row0', { SENSORPORT: '' }).split(' ')[0]!
  const lists = child.block('forever').locator('.ai_easy_list')
  const inputs = lists.filter({ hasNot: child.page.locator('.ai_nn_output_node') })
  const { x, y, height } = (await inputs.boundingBox())!
  const knobs = await child.knobs.count()
  await hands.searches(name)
  // A block of the sensors has the same words, and comes before.
  await hands.pulls(hands.hits.filter({ hasText: name }).last(), { x: x + 40, y: y + height - 24 })
  await expect(child.knobs).toHaveCount((knobs * 3) / 2)
}

/** Where its network drives wrong a child takes over: from places 2 and 3 by turns, slowly. */
async function coaches(child: Child) {
  const teaching = new Teaching(child)
  await new NetHands(child).chooses('explorer')
  await teaching.shows()
  await teaching.chooses('coach')
  await new TimeHands(child).chooses('0.5')
  const given = await teaching.count()
  for (let drives = 0; (await teaching.count()) < given + 20; drives += 1) {
    await child.presses('lab.place', { number: 2 + (drives % 2) })
    await teaching.helps()
  }
}

const isCoached = ({ examples }: Brain): boolean => (examples?.drives ?? []).some(({ by }) => by === 'coach')

const isMirrored = ({ practice }: Brain): boolean => practice?.settings.mirror ?? false

/** Those that the solution has more, where it was shown by hand: what was driven or helped is told by its drives. */
function rowsToShow(before: Brain, after: Brain): readonly Row[] {
  const rows = after.examples?.rows ?? []
  if (!before.examples) return rows
  return isCoached(after) ? [] : rows.slice(before.examples.rows.length)
}

/** Numbers of the rows that are off, from 1. */
const rowsToSetAside = ({ examples }: Brain): readonly number[] =>
  (examples?.rows ?? []).flatMap((row, at) => (row[place.on] === 0 ? [at + 1] : []))

const isDriven = ({ examples }: Brain) => examples!.drives.some(({ by }) => by === 'keys')

/** Bo is driven by keys from as many places as in the solution, with about as many examples. */
async function drives(child: Child, { examples }: Brain) {
  const teaching = new Teaching(child)
  const { drives, rows } = examples!
  for (const index of drives.keys()) {
    if (index > 0) await child.presses('lab.place', { number: index + 1 })
    await teaching.chooses('drive')
    await teaching.dodges(Math.round((rows.length * (index + 1)) / drives.length))
  }
}

/** Bo is put to each place, its wheels or its words are set, and that is remembered. */
async function showsRows(child: Child, rows: readonly Row[], { examples, layers }: Brain) {
  const teaching = new Teaching(child)
  // The whole floor can be reached then.
  await child.presses('world.all')
  const given = await teaching.count()
  for (const [index, row] of rows.entries()) {
    await teaching.puts({ x: row[place.x]!, y: row[place.y]!, heading: row[place.heading]! })
    const wishes = row.slice(headOfRow + examples!.inputs.length)
    const [left, right] = wishes
    if (layers.at(-1)!.length === 2) await teaching.remembers(left!, right!)
    else await teaching.remembersWords(wishes.flatMap((wish, k) => ((wish ?? 0) > 0 ? [k] : [])))
    await teaching.seesExamples(given + index + 1)
  }
}
