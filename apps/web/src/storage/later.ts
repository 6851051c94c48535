// What reads foreign files and links: only a click asks for it.
export { homeFiles, keepProject, openProjectFile } from './files.ts'
export { LinkError, readLink, writeLink } from './link.ts'
export { wordsOfRefusal } from './refusal.ts'
