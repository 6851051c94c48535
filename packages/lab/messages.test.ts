import { addBlocks } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import type { Program } from '@botgarten/programs'
import { readOpenRoberta } from '@botgarten/programs/open-roberta'
import { beforeAll, describe, expect, it } from 'vitest'
import type { Lab } from './index.ts'
import { labWith, worldWith } from './testing/scene.ts'

beforeAll(() => addBlocks(expert))

// ---- programs as Open Roberta writes them

let count = 0
const block = (type: string, inside = '') =>
  `<block type="${type}" id="m${(count += 1)}" intask="true">${inside}</block>`
const value = (name: string, inside: string) => `<value name="${name}">${inside}</value>`
const field = (name: string, text: string) => `<field name="${name}">${text}</field>`
const text = (words: string) => block('text', field('TEXT', words))
const number = (x: number) => block('math_number', field('NUM', String(x)))
const protocol = `<mutation datatype="String"></mutation>${field('TYPE', 'String')}${field('PROTOCOL', 'BLUETOOTH')}${field('CHANNEL', '-1')}<data>ev3</data>`

/** The program's one variable: its connection. */
const get = block('variables_get', `<mutation datatype="Connection"></mutation>${field('VAR', 'friend')}`)
const calls = (name: string) => block('robCommunication_startConnection', value('ADDRESS', text(name)))
const isCalled = () => block('robCommunication_waitForConnection')
const send = (words: string) =>
  block('robCommunication_sendBlock', protocol + value('sendData', text(words)) + value('CONNECTION', get))
const receive = () => block('robCommunication_receiveBlock', protocol + value('CONNECTION', get))
const show = (what: string, row: number) =>
  block('robActions_display_text', value('OUT', what) + value('COL', number(0)) + value('ROW', number(row)))
const wait = (ms: number) => block('robControls_wait_time', value('WAIT', number(ms)))

function program(connection: string, ...rows: readonly string[]): Program {
  const declared = block(
    'robGlobalVariables_declare',
    `<mutation next="false" declaration_type="Connection"></mutation>${field('VAR', 'friend')}${field('TYPE', 'Connection')}${value('VALUE', connection)}`,
  )
  const start = block(
    'robControls_start',
    `<mutation declare="true"></mutation>${field('DEBUG', 'FALSE')}<statement name="ST">${declared}</statement>`,
  )
  const ns = 'http://de.fhg.iais.roberta.blockly'
  return readOpenRoberta(
    `<export xmlns="${ns}"><program><block_set xmlns="${ns}" robottype="ev3" xmlversion="3.1" description="" tags=""><instance x="1" y="1">${start}${rows.join('')}</instance></block_set></program></export>`,
  )
}

// ---- two robots in one world

function labOf(first: Program, second: Program): Lab {
  const world = worldWith(2)
  const robots = world.robots.map((robot, k) => ({ ...robot, program: k === 0 ? 'main' : 'other' }))
  const lab = labWith(first, { ...world, robots }, { programs: { main: first, other: second } })
  lab.start()
  return lab
}

const shown = (lab: Lab, robot: number) =>
  lab
    .view()
    .robots[robot]!.display.map((row) => row.trim())
    .filter(Boolean)
const problem = (lab: Lab, robot: number) => lab.view().robots[robot]!.problem?.problem

describe('messages between two robots (semantics 37)', () => {
  it('what one sends the other reads, in order, each once', () => {
    const lab = labOf(
      program(calls('Bo 2'), send('one'), send('two'), wait(200), send('three')),
      program(isCalled(), show(receive(), 0), show(receive(), 1), show(receive(), 2)),
    )
    lab.advance(2)
    expect(shown(lab, 1)).toEqual(['one', 'two'])
    lab.advance(30)
    expect(shown(lab, 1)).toEqual(['one', 'two', 'three'])
    expect([problem(lab, 0), problem(lab, 1)]).toEqual([undefined, undefined])
    expect(lab.view().phase).toBe('ended')
  })

  it('a connection goes both ways: questions are answered', () => {
    const lab = labOf(
      program(calls('bo2'), send('ping'), show(receive(), 0)),
      program(isCalled(), show(receive(), 0), send('pong')),
    )
    lab.advance(5)
    expect([shown(lab, 0), shown(lab, 1)]).toEqual([['pong'], ['ping']])
  })

  it('the second robot may call the first, by its number', () => {
    const lab = labOf(program(isCalled(), show(receive(), 0)), program(calls('1'), wait(100), send('hello')))
    lab.advance(3)
    expect(shown(lab, 0)).toEqual([])
    lab.advance(10)
    expect(shown(lab, 0)).toEqual(['hello'])
  })

  it('who waits for a letter that never comes waits, and the other robot runs on', () => {
    const lab = labOf(program(calls('Bo 2'), wait(300)), program(isCalled(), show(receive(), 0)))
    lab.advance(120)
    expect(lab.view().phase).toBe('running')
    expect(shown(lab, 1)).toEqual([])
  })

  it('a robot that is not there, or the robot itself, cannot be called', () => {
    const lab = labOf(program(calls('Bo 7')), program(calls('Bo 2')))
    lab.advance(2)
    expect([problem(lab, 0), problem(lab, 1)]).toEqual(['problem.noSuchRobot', 'problem.noSuchRobot'])
  })

  it('letters belong to the moment: taken back and run again, the same is read', () => {
    const lab = labOf(
      program(calls('Bo 2'), wait(500), send('one'), wait(500), send('two')),
      program(isCalled(), show(receive(), 0), show(receive(), 1)),
    )
    lab.advance(90)
    const hash = lab.hash()
    expect(shown(lab, 1)).toEqual(['one', 'two'])
    lab.goTo(40)
    expect(shown(lab, 1)).toEqual(['one'])
    lab.goTo(20)
    expect(shown(lab, 1)).toEqual([])
    lab.branch()
    lab.resume()
    lab.advance(70)
    expect(shown(lab, 1)).toEqual(['one', 'two'])
    expect(lab.hash()).toBe(hash)
  })
})
