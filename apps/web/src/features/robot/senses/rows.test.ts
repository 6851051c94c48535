import type { Senses } from '@botgarten/lab'
import { cardConfig } from '@botgarten/simulation'
import { beforeAll, describe, expect, test } from 'vitest'
import { fetchWords, message } from '#words/message.ts'
import { rowsOf } from './rows.ts'

beforeAll(() => fetchWords('robot'))

const nothing = { ports: [], motors: [], timers: [] } as unknown as Senses
const reads = (values: object, locale = 'en') =>
  rowsOf({ ...nothing, ports: [{ port: '3', values }] } as unknown as Senses, cardConfig, locale)

describe('a sensor', () => {
  test.each([
    ['distance', 12.6, '13 cm'],
    ['light', 45.2, '45 %'],
    ['angle', -90, '−90°'],
    ['rate', 3, '3°/s'],
    ['x', 12.34, '12.3 cm'],
    ['sound', 2, '2'],
    ['distance', null, '–'],
  ])('that reads %s %j says %s', (mode, value, said) => {
    const [row] = reads({ [mode]: value })
    expect(row).toEqual({ id: `3 ${mode}`, place: '3', label: message(`robot.mode.${mode}`), value: said })
  })

  test('says numbers in the language', () => {
    expect(reads({ y: 1.25 }, 'de')[0]!.value).toBe('1,3 cm')
  })

  test('is pressed or free', () => {
    const values = [1, 0].map((value) => reads({ touch: value })[0]!.value)
    expect(values).toEqual([message('robot.pressed'), message('robot.free')])
  })

  test('names the colour that it sees, and shows it; one that it does not see is none', () => {
    const [red, none] = ['#B30006', ''].map((value) => reads({ colour: value })[0]!)
    expect([red!.colour, red!.value === '–']).toEqual(['#B30006', false])
    expect([none!.value, 'colour' in none!]).toEqual(['–', false])
  })

  test('has its three channels in one row', () => {
    const rows = reads({ red: 10.4, green: 20, blue: 29.6 })
    expect(rows.map(({ id, value }) => [id, value])).toEqual([['3 channels', '10 · 20 · 30']])
  })
})

test('motors are in the table where they drive a wheel or have turned, and timers by their number', () => {
  const { left, right } = cardConfig.drive
  const [other, turned] = (['A', 'B', 'C', 'D'] as const).filter((port) => port !== left && port !== right)
  const still = (port: string) => ({ port, percent: 0, turned: 0 })
  const motors = [still(left), { ...still(right), percent: 49.6, turned: 720.4 }, still(other!), { ...still(turned!), turned: -3 }] // prettier-ignore
  const rows = rowsOf({ ...nothing, motors, timers: [250.4, 3] } as unknown as Senses, cardConfig, 'en')
  expect(rows.map(({ id, value, place }) => [id, place, value])).toEqual([
    [`motor ${left}`, left, '0 %, 0°'],
    [`motor ${right}`, right, '50 %, 720°'],
    [`motor ${turned!}`, turned, '0 %, −3°'],
    ['timer 0', '1', '250 ms'],
    ['timer 1', '2', '3 ms'],
  ])
})
