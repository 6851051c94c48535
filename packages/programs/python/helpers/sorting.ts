import type { Helpers } from '../helpers.ts'

/** k-means on plain lists (Lloyd 1982); it begins with readings that lie far apart (Gonzalez 1985), the same every time. */
export const sorting: Helpers = {
  distance_to: ({ math }) => [
    '(reading, centre):',
    `return ${math('sqrt')}(sum([pow(a - b, 2) for a, b in zip(reading, centre)]))`,
  ],
  group_of: ({ call }) => [
    '(reading, centres):',
    `away = [${call('distance_to')}(reading, centre) for centre in centres]`,
    'return away.index(min(away)) + 1',
  ],
  name_of: () => ['(group, names):', 'return names.get(group, str(group))'],
  nearest: ({ call }) => [
    '(reading, centres):',
    `return min([${call('distance_to')}(reading, centre) for centre in centres])`,
  ],
  middle_of: () => ['(readings):', 'return [sum(parts) / len(readings) for parts in zip(*readings)]'],
  find_groups: ({ call }) => [
    '(readings, count):',
    'centres = [readings[0]]',
    'while len(centres) < count:',
    `    centres.append(max(readings, key=lambda one: ${call('nearest')}(one, centres)))`,
    'for _ in range(20):',
    `    groups = [${call('group_of')}(one, centres) for one in readings]`,
    '    for k in range(len(centres)):',
    '        own = [one for one, group in zip(readings, groups) if group == k + 1]',
    `        centres[k] = ${call('middle_of')}(own) if own else centres[k]`,
    'return centres',
  ],
}
