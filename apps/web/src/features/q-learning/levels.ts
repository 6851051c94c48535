/** starter: words and stars · explorer: values too · expert: parameters as numbers, decay, rules, the formula. */
export const levels = ['starter', 'explorer', 'expert'] as const
export type Level = (typeof levels)[number]
