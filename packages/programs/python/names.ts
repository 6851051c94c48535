/** Words of Python 3, and functions of its own that a file may call. */
const taken = [
  ...['False', 'None', 'True', 'and', 'as', 'assert', 'async', 'await', 'break', 'class', 'continue', 'def'],
  ...['del', 'elif', 'else', 'except', 'finally', 'for', 'from', 'global', 'if', 'import', 'in', 'is'],
  ...['lambda', 'nonlocal', 'not', 'or', 'pass', 'raise', 'return', 'try', 'while', 'with', 'yield'],
  ...['abs', 'bool', 'chr', 'float', 'int', 'isinstance', 'len', 'list', 'max', 'min', 'ord', 'pow', 'print'],
  ...[
    'range',
    'reversed',
    'round',
    'sorted',
    'str',
    'sum',
    'zip',
    'dict',
    'map',
    'match',
    'NotImplementedError',
    'all',
    'any',
    'bytes',
    'dir',
    'enumerate',
    'filter',
    'float',
    'format',
    'hash',
    'help',
    'id',
    'input',
    'iter',
    'next',
    'object',
    'open',
    'set',
    'slice',
    'super',
    'tuple',
    'type',
    'vars',
  ],
  ...[
    'ValueError',
    'choice',
    'randint',
    'random',
    'ceil',
    'exp',
    'floor',
    'fmod',
    'log',
    'pi',
    'sqrt',
    'sin',
  ],
  ...['cos', 'tan', 'asin', 'acos', 'atan', 'tanh', 'wait', 'sleep', 'StopWatch', 'Motor', 'DriveBase'],
  ...[
    'EV3Brick',
    'Port',
    'Color',
    'Button',
    'Direction',
    'Sound',
    'Display',
    'Leds',
    'MoveTank',
    'LargeMotor',
  ],
  ...['MediumMotor', 'SpeedDPS', 'TouchSensor', 'ColorSensor', 'UltrasonicSensor', 'GyroSensor'],
  ...['InfraredSensor', 'SoundSensor', 'PrimeHub', 'ForceSensor', 'Axis', '_'],
]

/** Letters that are easily taken for digits: no linter lets them stand alone (pycodestyle E741). */
const unclear = ['l', 'O', 'I']

/**
 * A text as a name of Python: what no name may hold becomes `_`. Letters of every alphabet stay, as Python reads them
 * (reference, 2.3: NFKC).
 */
export function validName(text: string): string {
  const joined = text.normalize('NFKC').replace(/[^\p{ID_Continue}]+/gu, '_')
  const name = joined.length > 1 ? joined.replace(/^_+(?=.)|_+$/g, '') : joined
  const begun = /^[\p{ID_Start}_]/u.test(name) && name !== '_' ? name : `x${name === '_' ? '' : `_${name}`}`
  return unclear.includes(begun) || taken.includes(begun) ? `${begun}_` : begun
}

/** Every name of one file, each once. What asks first has the name it wants. */
export class Names {
  readonly #used = new Set(taken)
  readonly #known = new Map<string, string>()

  /** The name for what `key` stands for; the same for the same key. */
  of(key: string, wanted: string): string {
    const known = this.#known.get(key)
    if (known !== undefined) return known
    const name = this.fresh(wanted)
    this.#known.set(key, name)
    return name
  }

  fresh(wanted: string): string {
    const plain = validName(wanted)
    let name = plain
    for (let k = 2; this.#used.has(name); k++) name = `${plain.replace(/_$/, '')}_${k}`
    this.#used.add(name)
    return name
  }
}
