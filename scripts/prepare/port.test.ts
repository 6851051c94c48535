import { expect, test } from 'vitest'
import { portFrom } from './port.mjs'

test('without a wish the lab opens at port 4173', () => {
  expect(portFrom([])).toBe(4173)
})

test('--port takes a port in both spellings', () => {
  expect(portFrom(['--port', '8080'])).toBe(8080)
  expect(portFrom(['--port=0'])).toBe(0)
})

test.each([['abc'], ['65536'], ['80.5'], ['1e99']])('%s is refused as a port, with an example', (port) => {
  expect(() => portFrom(['--port', port])).toThrow('npm start -- --port 8080')
})

test.each([[['--prot', '1']], [['8080']], [['--port']]])(
  '%j is refused, with the one option there is',
  (args) => {
    expect(() => portFrom(args)).toThrow('npm start -- --port 8080')
  },
)
