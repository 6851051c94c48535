import { addBlocks, type Template } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { cardConfig, defaultConfig } from '@botgarten/simulation'
import { beforeAll, describe, expect, it } from 'vitest'
import { block, number, programOf, show, start } from '../testing/build.ts'
import { pythonFrom } from './index.ts'

beforeAll(() => addBlocks(expert))

describe('a SPIKE Prime hub', () => {
  const spike = (rows: readonly Template[], config = cardConfig) =>
    pythonFrom(
      { ...{ name: 'test', program: programOf([start, ...rows]), config }, brains: {}, dialect: 'spike' },
      (key, facts = {}) => [key, ...(Object.values(facts) as unknown[])].join(' '),
    ).text
  const reading = (type: string, MODE: string, SENSORPORT: string) =>
    block(type, { MODE, SENSORPORT, SLOT: '' })
  const colour = reading('robSensors_colour_getSample', 'COLOUR', '1')
  const touch = reading('robSensors_touch_getSample', 'PRESSED', '1')
  const gyro = reading('robSensors_gyro_getSample', 'ANGLE', '2')
  const key = (KEY: string) =>
    block('robSensors_key_getSample', { MODE: 'PRESSED', SENSORPORT: KEY, SLOT: '' })
  const wait = (WAIT0: Template) => block('robControls_wait_for', {}, { WAIT0 })

  it('has six ports: motors keep theirs, sensors take those that are left', () => {
    const distance = reading('robSensors_ultrasonic_getSample', 'DISTANCE', '3')
    const file = spike([show(colour), show(distance)])
    expect(file).toContain('color_sensor = ColorSensor(Port.A)')
    expect(file).toContain('right_eye = UltrasonicSensor(Port.E)')
    expect(file).toContain('# python.plug A python.device.colour')
  })

  it('says it where no port is left', () => {
    const motors = { A: { kind: 'medium' }, B: { kind: 'large' }, C: { kind: 'large' }, D: { kind: 'large' } }
    const distance = reading('robSensors_ultrasonic_getSample', 'DISTANCE', '3')
    const file = spike([show(distance)], { ...cardConfig, motors } as typeof cardConfig)
    expect(file).toContain('# python.missing.ports\nshow("0")')
  })

  it('has a force sensor, and a gyroscope built in', () => {
    const file = spike([wait(touch), show(gyro)], defaultConfig)
    expect(file).toContain('touch_sensor = ForceSensor(Port.A)')
    expect(file).toContain('# python.plug A python.device.force')
    expect(file).toContain('show(number_text(hub.imu.heading()))')
  })

  it('tells its color sensor to know black and brown', () =>
    expect(spike([show(colour)])).toMatch(/color_sensor\.detectable_colors\(\n +\[\n +Color\.BLACK,/))

  it('keeps the key in the middle for the program that asks for it, and has no key above', () => {
    expect(spike([wait(key('ENTER'))])).toContain('hub.system.set_stop_button(Button.BLUETOOTH)')
    expect(spike([wait(key('UP'))])).toContain('# python.missing.key')
  })

  it('has its left wheel on the motor that looks the other way', () => {
    const file = spike([block('robActions_motorDiff_on', { DIRECTION: 'FOREWARD' }, { POWER: number(30) })])
    expect(file).toContain('left_motor = Motor(Port.C, Direction.COUNTERCLOCKWISE)')
    expect(file).toContain('right_motor = Motor(Port.B)')
  })
})
