import { addBlocks } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { content } from '@botgarten/content/files'
import { fileFrom, projectFrom } from '@botgarten/programs/open-roberta'
import { motorAt, motorPorts, withWheel } from '@botgarten/simulation'
import { afterEach, beforeEach, describe, expect, it } from 'vitest'
import { xmlTree } from '../../../../../../packages/programs/testing/xml-tree.ts'
import { closeSessions, screen, sessionOf } from '#lab/testing/session.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { rowsOf } from '../senses/rows.ts'
import { RobotBuilder } from './builder.svelte.ts'
import { kindAt, motorHelp, noteOf, wheelOf, withKind, withSetting } from './motors.ts'

addBlocks(expert)
beforeEach(freshDevice)
afterEach(closeSessions)

const field = (name: string, text: string) => `<field name="${name}">${text}</field>`
const plugged = (port: string, type: string, fields = '', id = port) =>
  `<value name="${port}"><block type="robBrick_${type}" id="${id}">${fields}</block></value>`
const motor = (regulated: string, reversed: string, wheel = '') =>
  field('MOTOR_REGULATION', regulated) +
  field('MOTOR_REVERSE', reversed) +
  (wheel && field('MOTOR_DRIVE', wheel))

/** An Open Roberta file whose robot has these parts, and whose program drives straight ahead forever. */
function fileWith(...parts: readonly string[]): string {
  const ns = 'http://de.fhg.iais.roberta.blockly'
  const set = (x: number, blocks: string) =>
    `<block_set xmlns="${ns}" robottype="ev3" xmlversion="3.1" description="" tags=""><instance x="${x}" y="20">${blocks}</instance></block_set>`
  const start = `<block type="robControls_start" id="start" intask="true"><mutation declare="false"></mutation>${field('DEBUG', 'FALSE')}</block>`
  const power = `<value name="POWER"><block type="math_number" id="power" intask="true">${field('NUM', '30')}</block></value>`
  const drive = `<block type="robActions_motorDiff_on" id="drive" intask="true">${field('DIRECTION', 'FOREWARD')}${power}</block>`
  const loop = `<block type="robControls_loopForever" id="loop" intask="true"><statement name="DO">${drive}</statement></block>`
  const brick = `<block type="robBrick_EV3-Brick" id="brick">${field('WHEEL_DIAMETER', '5.6')}${field('TRACK_WIDTH', '18')}${parts.join('')}</block>`
  return `<export xmlns="${ns}"><program>${set(20, start + loop)}</program><config>${set(213, brick)}</config></export>`
}

const file = fileWith(
  plugged('S4', 'irseeker'),
  plugged('MB', 'motor_big', motor('TRUE', 'ON', 'LEFT')),
  plugged('MC', 'motor_big', motor('TRUE', 'OFF', 'RIGHT')),
  plugged('MD', 'motor_middle', motor('FALSE', 'OFF')),
)

function opened(text: string) {
  const { session } = sessionOf(projectFrom(text, 'Plugs', content.world('garden')!), { isCard: false })
  const builder = new RobotBuilder(session)
  const saved = () => xmlTree(fileFrom(session.project, session.robotId))
  return { session, builder, saved }
}

describe('the motors of an Open Roberta file', () => {
  it('are listed by kind and wheel with their settings, and are saved unchanged', () => {
    const { builder, saved } = opened(file)
    const rows = motorPorts.map((port) => [port, kindAt(builder.config, port), wheelOf(builder.config, port)])
    expect(rows).toEqual([
      ['A', 'nothing', 'none'],
      ['B', 'large', 'left'],
      ['C', 'large', 'right'],
      ['D', 'medium', 'none'],
    ])
    expect(motorAt(builder.config, 'B')).toEqual({ kind: 'large', reversed: true })
    expect(motorAt(builder.config, 'D')).toEqual({ kind: 'medium', unregulated: true })
    expect(motorHelp.medium).toBe('robot.help.motor_middle')
    expect(builder.config.sensors['4']?.kind).toBe('irseeker')
    expect(saved()).toEqual(xmlTree(file))
  })

  it('are changed one setting a step, and the file has each of them', () => {
    const { session, builder, saved } = opened(file)
    const before = session.undo.count
    builder.change(withSetting(builder.config, 'B', 'reversed', false))
    builder.change(withSetting(builder.config, 'B', 'unregulated', true))
    builder.change(withKind(builder.config, 'A', 'large'))
    builder.change(withWheel(builder.config, 'A', 'right'))
    builder.change(withSetting(builder.config, 'A', 'reversed', true))
    builder.change(withKind(builder.config, 'D', 'other'))
    builder.change(withKind(builder.config, 'C', 'nothing'))
    expect(session.undo.count).toBe(before + 7)
    expect(kindAt(builder.config, 'C')).toBe('nothing')
    session.undo.undo()
    expect(kindAt(builder.config, 'C')).toBe('large')
    const changed = fileWith(
      plugged('S4', 'irseeker'),
      plugged('MA', 'motor_big', motor('TRUE', 'ON', 'RIGHT'), 'motorA'),
      plugged('MB', 'motor_big', motor('FALSE', 'OFF', 'LEFT')),
      plugged('MC', 'motor_big', motor('TRUE', 'OFF', 'NONE')),
      plugged('MD', 'actor', '', 'motorD'),
    )
    expect(saved()).toEqual(xmlTree(changed))
  })
})

describe('a left motor that turns backwards', () => {
  /** Runs for a second, and returns the speeds of both wheels as the table of senses shows them. */
  function speeds(reversed: boolean) {
    const { session, builder } = opened(file)
    builder.change(withSetting(builder.config, 'B', 'reversed', reversed))
    const note = noteOf(builder.config, 'B')
    const draw = screen()
    const stop = session.lab.run()
    session.start()
    for (let frame = 0; frame < 10; frame += 1) draw(100)
    stop()
    const rows = rowsOf(session.lab.senses(session.robotId), builder.config, 'en')
    const motors = rows.filter(({ id }) => id.startsWith('motor')).map(({ value }) => value.split(',')[0])
    return { note, motors }
  }

  it('makes the robot drive the other way, and the dialog announces that', () => {
    expect(speeds(true)).toEqual({ note: 'robot.otherWay', motors: ['−30 %', '−30 %'] })
    expect(speeds(false)).toEqual({ note: 'robot.onlyReal', motors: ['30 %', '30 %'] })
  })
})
