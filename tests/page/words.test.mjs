// Every word of the page stands in the table, with its German; and the table has nothing that the page does not say.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { test } from 'node:test';
import { root } from './support/server.mjs';

const ts = createRequire(new URL('../../web/package.json', import.meta.url))('typescript');
const src = join(root, 'web/src');
const files = readdirSync(src, { recursive: true }).filter((name) => /\.tsx?$/.test(name)).sort();
const parsed = (name) => ts.createSourceFile(name, readFileSync(join(src, name), 'utf8'), ts.ScriptTarget.Latest, true, name.endsWith('x') ? ts.ScriptKind.TSX : ts.ScriptKind.TS);

const each = (node, see) => {
  see(node);
  ts.forEachChild(node, (child) => each(child, see));
};

/** The sentence of t`…`, with {0}, {1} … for its values. */
function sentenceOf({ template }) {
  const parts = ts.isNoSubstitutionTemplateLiteral(template) ? [template.text] : [template.head.text, ...template.templateSpans.map(({ literal }) => literal.text)];
  return parts.reduce((all, part, i) => `${all}{${i - 1}}${part}`).trim();
}

function wordsUsed() {
  const used = new Set();
  for (const name of files) {
    each(parsed(name), (node) => {
      if (ts.isTaggedTemplateExpression(node) && node.tag.getText() === 't') used.add(sentenceOf(node));
      if (ts.isCallExpression(node) && node.expression.getText() === 'plural') {
        const [, one, many] = node.arguments;
        used.add(one.text);
        used.add(many ? many.text : `${one.text}s`);
      }
    });
  }
  return used;
}

function table(file = 'german.ts') {
  const rows = new Map();
  each(parsed(file), (node) => {
    if (!ts.isPropertyAssignment(node)) return;
    assert.ok(!rows.has(node.name.text), `twice in the table: ${node.name.text}`);
    rows.set(node.name.text, node.initializer.text);
  });
  return rows;
}

test('the table has the German of all that the page says, and nothing else', () => {
  const [used, rows] = [wordsUsed(), table()];
  assert.ok(used.size > 500, `${used.size} words are found`);
  assert.deepEqual([...used].filter((words) => !rows.has(words)), [], 'said without German');
  assert.deepEqual([...rows.keys()].filter((words) => !used.has(words)), [], 'in the table and never said');
});

test('both languages have the same values in a sentence', () => {
  const values = (text) => [...text.matchAll(/\{\d+\}/g)].map(([value]) => value).sort().join();
  for (const [english, german] of [...table(), ...table('program_german.ts')]) assert.equal(values(german), values(english), english);
});

/** Pieces of a sentence that follow one another in a source. */
const joined = (text) => text.replace(/"\s*\n\s*"/g, '');
const source = (name) => joined(readFileSync(join(root, name), 'utf8'));

/** What the program says, with {} for each value, and options in the words that the server has for the page. */
function programSays() {
  const all = [];
  for (const folder of ['src/tramline', 'apps/server']) {
    for (const name of readdirSync(join(root, folder), { recursive: true })) {
      if (!/\.(cpp|h)$/.test(name)) continue;
      for (const [, literal] of source(join(folder, name)).matchAll(/"((?:[^"\\\n]|\\.)*)"/g)) all.push(literal.replace(/\{[^}]*\}/g, '{}'));
    }
  }
  let says = all.join('\n');
  const options = [...source('apps/server/http/page_words.cpp').matchAll(/\{"([^"]+)",\s*"([^"]+)"\}/g)];
  assert.ok(options.length > 50, `${options.length} options`);
  for (const [, from, to] of options) {
    says = says.replaceAll(`smaller ${from}`, `smaller ${to.replace(/^the /, '')}`).replaceAll(from, to);
  }
  return new Set(says.split('\n'));
}

test('what has German words is what the program says', () => {
  const says = programSays();
  const rows = [...table('program_german.ts').keys()];
  assert.ok(rows.length > 40, `${rows.length} sentences`);
  assert.deepEqual(rows.filter((english) => !says.has(english.replace(/\{\d+\}/g, '{}'))), []);
});

/** Attributes that are read or seen. */
const SEEN = ['label', 'hint', 'title', 'ask', 'aria-label', 'placeholder', 'alt', 'says'];

test('no view says a word that is not in the table', () => {
  const bare = [];
  for (const name of files) {
    each(parsed(name), (node) => {
      if (ts.isJsxText(node) && /[a-z]{2}/i.test(node.text) && node.text.trim() !== 'tramline') bare.push(`${name}: ${node.text.trim()}`);
      if (ts.isJsxAttribute(node) && SEEN.includes(node.name.getText()) && node.initializer && ts.isStringLiteral(node.initializer) && /[a-z]{2}/i.test(node.initializer.text)) bare.push(`${name}: ${node.initializer.text}`);
    });
  }
  assert.deepEqual(bare.filter((where) => !/EPSG:/.test(where)), []);
});
