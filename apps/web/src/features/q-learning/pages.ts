export const pages = ['map', 'inside', 'curves', 'trials'] as const
export type Page = (typeof pages)[number]
