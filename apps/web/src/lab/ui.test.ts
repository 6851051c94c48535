import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { until } from '#storage/testing/device.ts'
import { friendship } from '#storage/testing/sample.ts'
import { closeSessions, screen, sessionOf } from './testing/session.ts'
import { LabUi } from './ui.svelte.ts'

const drawer = new Map<string, string>()
const page = { document: new EventTarget() as EventTarget & { hidden: boolean }, window: new EventTarget() }
let draw: (milliseconds?: number) => void = () => {}

beforeEach(() => {
  vi.spyOn(console, 'warn').mockImplementation(() => {})
  drawer.clear()
  page.document = Object.assign(new EventTarget(), { hidden: false })
  page.window = new EventTarget()
  for (const [name, value] of Object.entries(page)) vi.stubGlobal(name, value)
  vi.stubGlobal('Element', class extends EventTarget {})
  vi.stubGlobal('localStorage', {
    getItem: (name: string) => drawer.get(name) ?? null,
    setItem: (name: string, text: string) => drawer.set(name, text),
  })
  draw = screen()
})
afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

function opened(...how: Parameters<typeof sessionOf>) {
  const { session } = sessionOf(...how)
  session.learnFirst = () => false
  const ui = new LabUi(session)
  return { session, ui, close: ui.open() }
}
const press = (key: string, held: object = {}) => {
  const event = Object.assign(new Event('keydown', { cancelable: true }), {
    ...{ key, ctrlKey: false, metaKey: false, shiftKey: false, altKey: false },
    ...held,
  })
  page.window.dispatchEvent(event)
  return event
}
const turnAway = (hidden: boolean) => {
  page.document.hidden = hidden
  page.document.dispatchEvent(new Event('visibilitychange'))
}
/** Blockly has told of everything that a hand has done. */
async function told() {
  for (let turn = 0; turn < 4; turn += 1) {
    draw(0)
    await new Promise((done) => setTimeout(done, 1))
  }
}
const place = (x: number) => ({ kind: 'place', id: 'bo', after: { x, y: 300, heading: 0 } }) as const

test('bumping is a mistake on a card, but not for who learns by trying, nor in the free lab', () => {
  addBlocks(learning)
  const { card, world } = content.card('try-dodge')!
  const tries = cardProject(world, card, content.program('try-dodge', 'solution')!, 'try-dodge')
  expect(opened().ui.bumpIsMistake).toBe(true)
  expect(opened(friendship, { isCard: false }).ui.bumpIsMistake).toBe(false)
  expect(opened(tries).ui.bumpIsMistake).toBe(false)
})

describe('a hidden page', () => {
  test('pauses a run, saves, and says so on return', async () => {
    const { session, ui } = opened()
    ui.start()
    await told()
    draw()
    session.apply(place(100))
    turnAway(false)
    expect([session.lab.view.phase, ui.notice]).toEqual(['running', null])
    turnAway(true)
    expect([session.lab.view.phase, ui.notice]).toEqual(['paused', 'away'])
    // Without waiting for the pause after which it would be saved.
    await until(() => session.autosave.state !== 'saving')
  })

  test('says nothing where nothing ran', () => {
    const { session, ui } = opened()
    turnAway(true)
    expect([session.lab.view.phase, ui.notice]).toEqual(['ready', null])
  })
})

describe('keys', () => {
  test('Escape stops, other keys do not', async () => {
    const { session, ui } = opened()
    ui.start()
    await told()
    press('x')
    expect(session.lab.view.phase).toBe('running')
    press('Escape')
    expect(session.lab.view.phase).not.toBe('running')
  })

  test('Escape closes an open hint first, and stops with the next press', async () => {
    const { session, ui } = opened()
    ui.start()
    await told()
    ui.hintOpen = true
    press('Escape')
    expect([ui.hintOpen, session.lab.view.phase]).toEqual([false, 'running'])
    press('Escape')
    expect(session.lab.view.phase).not.toBe('running')
  })

  test('Ctrl+Z takes back once Blockly has told of everything, Ctrl+Y does it again', async () => {
    const { session } = opened()
    session.apply(place(100))
    const x = () => session.lab.view.robots[0]!.pose.x
    expect(press('z', { ctrlKey: true }).defaultPrevented).toBe(true)
    expect(x()).toBe(100)
    await told()
    expect(x()).toBe(440)
    press('y', { ctrlKey: true })
    await told()
    expect(x()).toBe(100)
    expect(press('z').defaultPrevented).toBe(false)
  })

  test('are heard no more once it is closed', async () => {
    const { session, ui, close } = opened()
    const closed = vi.spyOn(ui.speaker, 'close')
    ui.start()
    await told()
    close()
    press('Escape')
    turnAway(true)
    expect([session.lab.view.phase, ui.notice]).toEqual(['running', null])
    expect(closed).toHaveBeenCalledOnce()
  })
})

describe('a run', () => {
  test('has the blocks that a hand has joined just before, of which Blockly tells a little later', async () => {
    const { stacks, ...program } = friendship.programs['main']!
    const [first] = stacks
    const short = { ...program, stacks: [{ ...first!, blocks: first!.blocks.slice(0, 1) }] }
    const { session, ui } = opened({ ...friendship, programs: { main: short } }, { isCard: false })
    ui.start()
    draw()
    session.apply({ kind: 'program', program: 'main', after: friendship.programs['main']! })
    await told()
    for (let frame = 0; frame < 20; frame += 1) draw()
    expect(session.lab.view.phase).toBe('running')
  })

  test('from elsewhere than the card says is told so; a new one, or a start pose, takes the words away', async () => {
    const { session, ui } = opened()
    session.apply(place(111))
    ui.start()
    await told()
    expect(ui.notice).toBe('elsewhere')
    session.lab.stop()
    ui.chooseStart(1)
    expect([ui.notice, session.chosenStart]).toEqual([null, 1])
    ui.notice = 'bumped'
    ui.start()
    await told()
    expect(ui.notice).toBeNull()
  })

  test('can begin where it counts again by one press', async () => {
    const { session, ui } = opened()
    session.apply(place(111))
    ui.start()
    await told()
    expect(ui.notice).toBe('elsewhere')
    ui.toStart()
    expect([ui.notice, ui.success, session.chosenStart]).toEqual([null, null, 0])
    expect(session.lab.view.phase).toBe('ready')
  })

  test('that cannot begin shows why, and steps nowhere', async () => {
    const { session, ui } = opened()
    session.apply({ kind: 'config', id: 'bo', after: { ...session.config, sensors: {} } })
    ui.step('block')
    await told()
    expect(ui.shown?.stops).toBe(true)
    expect(session.lab.view.phase).toBe('ready')
    ui.show(null)
    expect(ui.shown).toBeNull()
  })

  test('is begun by a step, also again when it has ended, but not while it goes on', async () => {
    const { stacks, ...program } = friendship.programs['main']!
    const [first] = stacks
    const short = { ...program, stacks: [{ ...first!, blocks: first!.blocks.slice(0, 1) }] }
    const { session } = sessionOf({ ...friendship, programs: { main: short } }, { isCard: false })
    session.learnFirst = () => false
    const begun: string[] = []
    session.listen(({ kind }) => begun.push(kind))
    const ui = new LabUi(session)
    ui.open()
    ui.step('block')
    await told()
    expect(begun).toEqual(['begun'])
    session.lab.resume()
    for (let frame = 0; frame < 20; frame += 1) draw()
    expect(session.lab.view.phase).toBe('ended')
    ui.step('block')
    await told()
    expect(begun).toEqual(['begun', 'begun'])
    const going = opened()
    going.ui.start()
    await told()
    going.session.listen(({ kind }) => begun.push(kind))
    going.ui.step('block')
    await told()
    expect(begun).toHaveLength(2)
  })
})

describe('what is said', () => {
  test('at first: a floor that is missing, a project that could be read in parts', () => {
    expect(opened(undefined, { error: 'floorMissing' }).ui.notice).toBe('floorMissing')
    const { ui } = opened(undefined, { error: 'partlyHere', damaged: { name: 'a', raw: {} } })
    expect(ui.notice).toBeNull()
    expect(ui.message).toMatchObject({
      title: 'session.partlyHere',
      text: 'session.partlyHereText',
      facts: {},
    })
    expect(ui.message?.onsaveraw).toBeTypeOf('function')
    const plain = opened().ui
    expect([plain.notice, plain.message]).toEqual([null, null])
  })

  test('in a dialog: keys of words, with their facts', () => {
    const { ui } = opened()
    ui.announce('a.title', 'a.text', { count: 2 })
    expect(ui.message).toEqual({ title: 'a.title', text: 'a.text', facts: { count: 2 } })
    ui.announce('b', 'c')
    expect(ui.message).toEqual({ title: 'b', text: 'c', facts: {} })
  })

  test('nothing has succeeded yet', () => {
    const { ui } = opened()
    ui.closeSuccess()
    expect(ui.success).toBeNull()
  })
})

test('settings and sizes stay on this device', () => {
  const { ui } = opened()
  expect(ui.settings).toEqual({ rays: true, trail: true })
  expect(ui.sizes).toEqual({})
  ui.settings = { rays: false, trail: true }
  ui.sizes = { columns: [0.3, 0.4] }
  const again = opened().ui
  expect(again.settings).toEqual({ rays: false, trail: true })
  expect(again.sizes).toEqual({ columns: [0.3, 0.4] })
})
