import type { Helpers } from '../helpers.ts'

/** Functions that Python itself does not have, the same for every robot. */
export const general: Helpers = {
  number_text: () => [
    '(number):',
    'digits = "{:.4f}".format(round(number, 4) + 0.0)',
    'return digits.rstrip("0").rstrip(".")',
  ],
  truth_text: () => ['(truth):', 'return "true" if truth else "false"'],
  list_text: () => ['(entries, text):', 'return "[" + ", ".join(text(entry) for entry in entries) + "]"'],
  mean: () => ['(numbers):', 'return sum(numbers) / len(numbers)'],
  median: () => [
    '(numbers):',
    'ordered = sorted(numbers)',
    'middle = len(ordered) // 2',
    'if len(ordered) % 2 == 1:',
    '    return ordered[middle]',
    'return (ordered[middle - 1] + ordered[middle]) / 2',
  ],
  deviation: ({ call, math }) => [
    '(numbers):',
    `middle = ${call('mean')}(numbers)`,
    `return ${math('sqrt')}(${call('mean')}([(number - middle) ** 2 for number in numbers]))`,
  ],
  is_prime: () => [
    '(number):',
    'if number < 2 or number % 1 != 0:',
    '    return False',
    'divisor = 2',
    'while divisor * divisor <= number:',
    '    if number % divisor == 0:',
    '        return False',
    '    divisor += 1',
    'return True',
  ],
  random_between: ({ at, math }) => [
    '(one, other):',
    `low, high = ${math('ceil')}(min(one, other)), ${math('floor')}(max(one, other))`,
    `return ${at.from('random', 'randint')}(low, max(low, high))`,
  ],
  to_number: () => [
    '(text):',
    'text = text.replace(",", ".", 1)',
    'for end in range(len(text), 0, -1):',
    '    try:',
    '        return float(text[:end])',
    '    except ValueError:',
    '        pass',
    'raise ValueError(text)',
  ],
  first_place: () => ['(entries, wanted):', 'return entries.index(wanted) if wanted in entries else -1'],
  last_place: () => [
    '(entries, wanted):',
    'for place in range(len(entries) - 1, -1, -1):',
    '    if entries[place] == wanted:',
    '        return place',
    'return -1',
  ],
  part_of: () => [
    '(entries, first, last):',
    'if first < 0:',
    '    first += len(entries)',
    'if last < 0:',
    '    last += len(entries)',
    'return entries[first : last + 1]',
  ],
  check: () => ['(name, holds):', 'print(name, "holds" if holds else "does not hold")'],
}
