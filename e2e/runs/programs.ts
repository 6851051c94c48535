import type { Document } from '@botgarten/lab'
import { Blocks } from './blocks.ts'

type Behaviour = Pick<Document, 'programs' | 'brains'>

/** Eyes straight to the wheels, and a floor that pushes: it never stands still. `k` varies the weights. */
function followsEyes(k: number): Behaviour {
  const make = new Blocks()
  const inputs = [make.eye('2'), make.eye('3'), make.brightness()]
  const outputs = [make.wheel('C'), make.wheel('B')]
  const weights = [
    [0.35 + 0.1 * k, 0.05 * k],
    [0.15, 0.55 - 0.1 * k],
    [0.4, 0.35],
  ]
  const { block, brain } = make.net(inputs, outputs, weights)
  return { programs: { main: make.program(make.forever(block)) }, brains: { [block.id]: brain } }
}

/** Pushes in long strokes, forwards and back, curving. */
function strokes(k: number): Behaviour {
  const make = new Blocks()
  const both = (left: number, right: number) => [
    make.motor('C', make.number(left)),
    make.motor('B', make.number(right)),
    make.wait(900 + 170 * k),
  ]
  const main = make.program(make.forever(...both(90, 70 + 7 * k), ...both(-35, -60), ...both(100, 100)))
  return { programs: { main }, brains: {} }
}

/** Turns on dark floor and near things, else drives on. */
function decides(k: number): Behaviour {
  const make = new Blocks()
  const dark = make.compare('LT', make.floor('LIGHT'), make.number(40 + 5 * k))
  const near = make.compare('LT', make.distance('2'), make.number(12))
  const away = () => [make.turnRight(60, 47 + 13 * k)]
  const on = [make.motor('C', make.number(70)), make.motor('B', make.number(64 + k))]
  const main = make.program(make.forever(make.ifElse(dark, away(), [make.ifElse(near, away(), on)])))
  return { programs: { main }, brains: {} }
}

/** Measured ways and turns, over and over. */
function measures(k: number): Behaviour {
  const make = new Blocks()
  const leg = [make.drive(100, 37 + 11 * k), make.turnRight(80, 71 + k)]
  const main = make.program(make.forever(make.repeat(3, ...leg), make.drive(40, -21)))
  return { programs: { main }, brains: {} }
}

/** Speeds worked out from distances. */
function calculates(k: number): Behaviour {
  const make = new Blocks()
  const speed = (port: string, more: number) =>
    make.calculate(
      'ADD',
      make.calculate('DIVIDE', make.distance(port), make.number(3 + k)),
      make.number(more),
    )
  const main = make.program(
    make.forever(make.motor('C', speed('3', 31)), make.motor('B', speed('2', 22 + k))),
  )
  return { programs: { main }, brains: {} }
}

/** Five ways to behave, each with a number 0..3 that varies it. */
export const behaviours = { followsEyes, strokes, decides, measures, calculates }
