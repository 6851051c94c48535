import type { HelperAt, Helpers } from '../helpers.ts'
import { constantOf, lessonIn } from '../lesson.ts'

/** The key in the middle: is it pressed, and is it not? */
function middleKey({ at }: HelperAt): readonly [pressed: string, released: string] {
  const key = at.robot.key('enter')
  const pressed = key?.code ?? 'False'
  return [pressed, key?.not ?? `not ${pressed}`]
}

/** Straight on for the length of the road; where the color sensor sees no station there, up to 10 cm more. */
function alongRoad(h: HelperAt): readonly string[] {
  const { sensors } = h.draft.input.config
  const port = (['1', '2', '3', '4'] as const).find((one) => sensors[one]?.kind === 'colour')
  const color = port && h.at.robot.read('colour', port, 'colour')?.code
  if (!color) return [h.at.robot.straight('30', 'length')]
  const bare = ['#FFFFFF', '#585858'].map((colour) => h.at.robot.colour(colour)).join(', ')
  return [
    h.at.robot.straight('30', 'length'),
    'for _ in range(10):',
    `    color = ${color}`,
    `    if color not in (${bare}):`,
    '        break',
    `    ${h.at.robot.straight('15', '1')}`,
  ]
}

/** A learning rate that falls with the visits of a road, or with the episodes. */
function rates({ draft }: HelperAt) {
  const { alphaDecay, rhoDecay } = lessonIn(draft)?.settings ?? {}
  const factor = (decay: typeof alphaDecay) => (decay?.kind === 'episodes' ? decay.factor : 1)
  return { byVisits: alphaDecay?.kind === 'visits', alpha: factor(alphaDecay), rho: factor(rhoDecay) }
}

/** Q-learning on a floor with stations: Sutton & Barto, 2nd edition, 6.5, with the draws of running.md 13. */
export const learner: Helpers = {
  pick: ({ at }) => ['(choices):', `return choices[int(${at.from('random', 'random')}() * len(choices))]`],
  best_of: (h) => [
    '(station):',
    `values = ${constantOf(h.draft, 'table')}[station]`,
    'most = max(values.values())',
    'best = [one for one in sorted(values) if values[one] == most]',
    `return best[0] if len(best) == 1 else ${h.call('pick')}(best)`,
  ],
  put_down: (h) => {
    const [pressed, released] = middleKey(h)
    return [
      '(station):',
      h.at.robot.show('str(station)', '0', '0'),
      `while ${released}:`,
      `    ${h.at.robot.wait('10')}`,
      `while ${pressed}:`,
      `    ${h.at.robot.wait('10')}`,
      'return 0',
    ]
  },
  drive_to: (h) => [
    '(station, following, heading):',
    `direction, length = ${constantOf(h.draft, 'roads')}[station][following]`,
    h.at.robot.turn('30', '(direction - heading + 180) % 360 - 180'),
    ...alongRoad(h),
    'return direction',
  ],
  update: (h) => {
    const table = constantOf(h.draft, 'table')
    return [
      '(station, following, rate):',
      `reward = ${constantOf(h.draft, 'rewards')}.get((station, following), 0)`,
      'ahead = 0',
      `if following not in ${constantOf(h.draft, 'ends')}:`,
      `    ahead = max(${table}[following].values())`,
      `aim = reward + ${constantOf(h.draft, 'gamma')} * ahead`,
      `${table}[station][following] = (1 - rate) * ${table}[station][following] + rate * aim`,
    ]
  },
  learn: (h) => {
    const [random, pick] = [h.at.from('random', 'random'), h.call('pick')]
    const named = (what: Parameters<typeof constantOf>[1]) => constantOf(h.draft, what)
    const { byVisits, alpha, rho } = rates(h)
    const longest = 20 * h.draft.input.learned!.lesson!.states
    return [
      '(episodes, moves):',
      `rate, exploring = ${named('alpha')}, ${named('rho')}`,
      ...(byVisits ? ['visits = {}'] : []),
      'station, heading, steps = None, 0, 0',
      'while episodes > 0 and moves > 0:',
      `    curious, lost = ${random}(), ${random}()`,
      `    if lost < ${named('nu')} or station is None:`,
      `        station = ${pick}(${named('open')}) if lost < ${named('nu')} else ${named('start')}`,
      `        heading = ${h.call('put_down')}(station)`,
      '    if curious < exploring:',
      `        following = ${pick}(sorted(${named('table')}[station]))`,
      '    else:',
      `        following = ${h.call('best_of')}(station)`,
      `    heading = ${h.call('drive_to')}(station, following, heading)`,
      ...(byVisits
        ? [
            '    road = (station, following)',
            '    visits[road] = visits.get(road, 0) + 1',
            `    ${h.call('update')}(station, following, rate * 10 / (9 + visits[road]))`,
          ]
        : [`    ${h.call('update')}(station, following, rate)`]),
      '    station, steps, moves = following, steps + 1, moves - 1',
      `    if station in ${named('ends')} or steps == ${longest}:`,
      '        station, steps, episodes = None, 0, episodes - 1',
      ...(alpha === 1 ? [] : [`        rate *= ${alpha}`]),
      ...(rho === 1 ? [] : [`        exploring *= ${rho}`]),
      `print(${named('table')})`,
    ]
  },
  drive_best_way: (h) => {
    const [start, ends] = [constantOf(h.draft, 'start'), constantOf(h.draft, 'ends')]
    return [
      '():',
      `station, heading = ${start}, ${h.call('put_down')}(${start})`,
      `for _ in ${constantOf(h.draft, 'table')}:`,
      `    if station in ${ends}:`,
      '        break',
      `    following = ${h.call('best_of')}(station)`,
      `    heading = ${h.call('drive_to')}(station, following, heading)`,
      '    station = following',
    ]
  },
}
